// SPDX-License-Identifier: MIT
// The inner loops with the instructions that every processor of the target has.
#define LEONHARD_SWEEP_BUILD baseline
#define LEONHARD_SWEEP_LABEL "baseline"
#include "leonhard/solver/sweep/sweep_impl.hpp"
