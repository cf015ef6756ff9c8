// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

namespace leonhard::mesh {

/// An exact sum of products of doubles: a fixed-point number wide enough for every product of three finite doubles,
/// kept in digits of 32 bits with their carries put off. One product costs a few nanoseconds whatever the number of
/// summands, where rational numbers would grow. throws InputError, unchanged, for a number that is NaN or infinite.
/// Source: Kulisch and Miranker, Computer Arithmetic in Theory and Practice (1981), the long accumulator.
class ExactSum {
 public:
  /// Add a b. Both finite.
  void add_product(double a, double b);

  /// Add a b c. All finite.
  void add_product(double a, double b, double c);

  /// Add the cross product ax by - ay bx. All finite.
  void add_cross(double ax, double ay, double bx, double by) {
    add_product(ax, by);
    add_product(-ay, bx);
  }

  /// Add the determinant of three rows p, q, r, that is p . q x r. All finite.
  void add_determinant(const Point3& p, const Point3& q, const Point3& r);

  [[nodiscard]] Sign sign() const;
  [[nodiscard]] mpq_class value() const;

 private:
  // A double is m 2^e with e >= -1074 and a product of three has 159 bits, the highest below 2^3072: 6294 bits from
  // 2^-3222 up, 197 digits, and one more for the carries.
  static constexpr int lowest_exponent = -3222;
  static constexpr std::size_t digit_count = 198;
  using Digits = std::array<std::int64_t, digit_count>;

  /// The same number with all digits but the last in [0, 2^32).
  [[nodiscard]] static Digits carried(Digits digits);

  void count_addition();

  Digits digits_{};
  std::uint32_t additions_{};  ///< since the last carry: a digit grows by less than 2^33 each
};

}  // namespace leonhard::mesh
