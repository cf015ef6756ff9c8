// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/sweep.hpp"

namespace leonhard::solver {

template <int dim>
const SweepKernels<dim>& best_sweep() {
#if defined(LEONHARD_HAS_AVX2_SWEEP)
  if (__builtin_cpu_supports("avx2")) return SweepBuilds<dim>::avx2;
#endif
  return SweepBuilds<dim>::baseline;
}

template const SweepKernels<2>& best_sweep<2>();
template const SweepKernels<3>& best_sweep<3>();

}  // namespace leonhard::solver
