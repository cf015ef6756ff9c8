// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/sweep.hpp"

namespace leonhard::solver {

const SweepKernels& best_sweep() {
#if defined(LEONHARD_HAS_AVX2_SWEEP)
  if (__builtin_cpu_supports("avx2")) return sweep_avx2;
#endif
  return sweep_baseline;
}

}  // namespace leonhard::solver
