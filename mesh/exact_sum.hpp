// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>

#include "leonhard/kernel/sign.hpp"

namespace leonhard::mesh {

/// An exact sum of products of doubles: a fixed-point number wide enough for every product of two finite doubles,
/// kept in digits of 32 bits with their carries put off. One product costs a few nanoseconds whatever the number of
/// summands, where rational numbers would grow.
/// Source: Kulisch and Miranker, Computer Arithmetic in Theory and Practice (1981), the long accumulator.
class ExactSum {
 public:
  /// Add a b. Both finite.
  void add_product(double a, double b);

  /// Add the cross product ax by - ay bx. All finite.
  void add_cross(double ax, double ay, double bx, double by) {
    add_product(ax, by);
    add_product(-ay, bx);
  }

  [[nodiscard]] Sign sign() const;
  [[nodiscard]] mpq_class value() const;

 private:
  // A double is m 2^e with e >= -1074 and a product has 106 bits, the highest below 2^2048: 4196 bits from 2^-2148
  // up, 132 digits, and one more for the carries.
  static constexpr int lowest_exponent = -2148;
  static constexpr std::size_t digit_count = 133;
  using Digits = std::array<std::int64_t, digit_count>;

  /// The same number with all digits but the last in [0, 2^32).
  [[nodiscard]] static Digits carried(Digits digits);

  Digits digits_{};
  std::uint32_t additions_{};  ///< since the last carry: a digit grows by less than 2^32 each
};

}  // namespace leonhard::mesh
