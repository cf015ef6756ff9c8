// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace leonhard {

/// The answer of every predicate: never a double that someone might compare with an epsilon.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

/// The word for it, e.g. "negative".
[[nodiscard]] constexpr std::string_view to_string(Sign s) {
  switch (s) {
    case Sign::negative:
      return "negative";
    case Sign::zero:
      return "zero";
    case Sign::positive:
      return "positive";
  }
  return "";
}

[[nodiscard]] constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<signed char>(s)); }

[[nodiscard]] constexpr Sign operator*(Sign s, Sign t) {
  return static_cast<Sign>(static_cast<signed char>(s) * static_cast<signed char>(t));
}

/// The sign of a number whose value is exact (a rounded value has no business here).
template <class Number>
[[nodiscard]] constexpr Sign sign_of(const Number& x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

}  // namespace leonhard
