// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "leonhard/kernel/sign.hpp"

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "leonhard: exact predicates cannot be compiled with -ffast-math or a part of it"
#endif

/// What the floating-point filters of predicates.hpp and predicates3.hpp share, and what a filter of one's own is made of:
///
///     const double determinant = ..., bound = ...;  // |determinant - exact| <= bound where nothing underflows
///     if (const auto s = kernel::sign_if_beyond(determinant, bound); s.is_certain()) return *s;
///     return slow_but_exact(...);
///
/// Notation of their error bounds: u = 2^-53, the largest relative error of one operation that does not
/// underflow; addition and subtraction never underflow; a product that does is wrong by 2^-1075 at most. An
/// overflow makes |determinant| - bound infinite or NaN, and the filter does not answer. All bounds hold with
/// and without fused multiply-add, which only leaves roundings out; round-to-nearest is required
/// (floating_point_self_test says whether it is on).
namespace leonhard::kernel {

/// What a filter says: a sign that is certainly right, or that it cannot tell. It never proves zero.
class FilteredSign {
 public:
  constexpr FilteredSign() = default;
  explicit constexpr FilteredSign(Sign certain) : sign_(certain) {}

  [[nodiscard]] constexpr bool is_certain() const { return sign_ != Sign::zero; }
  /// The sign, if it is certain.
  [[nodiscard]] constexpr Sign operator*() const { return sign_; }

 private:
  Sign sign_ = Sign::zero;  // zero: cannot tell
};

namespace detail {

/// Larger than all that underflow can add to the error of a filter, and far above the subnormal numbers.
inline constexpr double underflow_guard = 0x1p-1000;

}  // namespace detail

/// The sign of value, if |value| - bound is at least `guard` and finite: then the value's error, at most `bound`
/// and a few smallest numbers, cannot have turned the sign, and nothing has overflowed. Uncertain where value or bound is
/// NaN or infinite, so a determinant or a bound that all its coordinates enter need not be checked for such.
///
/// One comparison of bit patterns does it: those of doubles >= 0 are in the order of the numbers, those of infinity,
/// NaN and negative numbers come after.
[[nodiscard]] inline FilteredSign sign_if_beyond(double value, double bound,
                                                 double guard = detail::underflow_guard) {
  const auto lowest = std::bit_cast<std::uint64_t>(guard);
  constexpr auto infinite = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  const double margin = std::abs(value) - bound;
  if (std::bit_cast<std::uint64_t>(margin) - lowest < infinite - lowest) [[likely]]
    return FilteredSign(
        static_cast<Sign>(std::bit_cast<std::int64_t>(value) >> 63 | 1));  // sign bit: -1, else 1
  return {};
}

}  // namespace leonhard::kernel
