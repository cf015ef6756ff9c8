// SPDX-License-Identifier: MIT
// The filters of batches with AVX2 and fused multiply-add, which this file alone is compiled with.
#define LEONHARD_BATCH_NAME batch_filters_avx2
#define LEONHARD_BATCH_LABEL "avx2"
#include "leonhard/kernel/batch/batch_filters_impl.hpp"
