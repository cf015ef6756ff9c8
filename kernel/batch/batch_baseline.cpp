// SPDX-License-Identifier: MIT
// The filters of batches with the instructions that every processor of the target has.
#define LEONHARD_BATCH_NAME batch_filters_baseline
#define LEONHARD_BATCH_LABEL "baseline"
#include "leonhard/kernel/batch/batch_filters_impl.hpp"
