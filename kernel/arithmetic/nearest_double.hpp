// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

namespace leonhard::kernel {

/// numerator / denominator 2^exponent rounded to the nearest double, ties to even; infinite from 2^1024 - 2^970 on in
/// size, as IEEE 754 has it.
///
/// denominator  not 0
/// mpq_get_d of GMP rounds to zero.
[[nodiscard]] double nearest_double(const mpz_class& numerator, const mpz_class& denominator, int exponent);

}  // namespace leonhard::kernel
