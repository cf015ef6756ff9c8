// SPDX-License-Identifier: MIT
// The inner loops with AVX2 (this file alone is compiled with -mavx2; contraction stays off, so the bits are those of
// the baseline).
#define LEONHARD_SWEEP_BUILD avx2
#define LEONHARD_SWEEP_LABEL "avx2"
#include "leonhard/solver/sweep/sweep_impl.hpp"
