// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/arithmetic/expansion.hpp"

/// Arithmetic with about 106 bits, after M. Joldes, J.-M. Muller and V. Popescu, "Tight and rigorous error bounds for
/// basic building blocks of double-word arithmetic", ACM Transactions on Mathematical Software 44 (2017). The bounds
/// hold, with u = 2^-53, where nothing overflows and up to a few smallest numbers where something underflows.
namespace leonhard::kernel {

/// high + low, high being the rounding of the sum.
struct DoubleDouble : TwoTerms {};

/// Relative error at most 3u^2 / (1 - 4u): their algorithm 6.
[[nodiscard]] inline DoubleDouble operator+(DoubleDouble x, DoubleDouble y) {
  const TwoTerms high = two_sum(x.high, y.high), low = two_sum(x.low, y.low);
  const TwoTerms sum = fast_two_sum(high.high, high.low + low.high);
  return {fast_two_sum(sum.high, low.low + sum.low)};
}

[[nodiscard]] inline DoubleDouble operator-(DoubleDouble x, DoubleDouble y) {
  return x + DoubleDouble{{-y.high, -y.low}};
}

/// Relative error at most 7u^2: their algorithm 10.
[[nodiscard]] inline DoubleDouble operator*(DoubleDouble x, DoubleDouble y) {
  const TwoTerms product = two_product(x.high, y.high);
  return {fast_two_sum(product.high, product.low + (x.high * y.low + x.low * y.high))};
}

}  // namespace leonhard::kernel
