// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "leonhard/kernel/arithmetic/expansion.hpp"
#include "leonhard/kernel/double_double.hpp"
#include "leonhard/kernel/filtered_sign.hpp"
#include "leonhard/kernel/sign.hpp"

/// Interval arithmetic in the form value and radius, which needs no directed rounding.
///
/// The radius is itself computed with rounding. It is a sum of products of numbers >= 0, so that k operations in a row
/// make it too small by a factor of at most (1 - u)^k: whoever reads one enlarges it by 2^-40 of itself (`inflated`),
/// enough for thousands of them. Overflow makes the radius infinite or NaN, and then no sign is certain.
namespace leonhard::kernel {

/// A real number no farther than `radius` from `value`, which is a double or a DoubleDouble.
template <class Value>
struct NumberBall {
  Value value;
  double radius;
};

namespace detail {

/// What one operation adds to the radius, in parts of its result, u = 2^-53: u for doubles; 4u^2 for a sum and 8u^2
/// for a product of DoubleDoubles, a little more than the bounds in double_double.hpp to make up for taking the high
/// part as the result.
template <class Value>
struct Rounding;
template <>
struct Rounding<double> {
  static constexpr double sum = 0x1p-53, product = 0x1p-53;
};
template <>
struct Rounding<DoubleDouble> {
  static constexpr double sum = 0x1p-104, product = 0x1p-103;
};

[[nodiscard]] inline double leading(double x) { return x; }
[[nodiscard]] inline double leading(DoubleDouble x) { return x.high; }

template <class Value>
[[nodiscard]] double magnitude(const NumberBall<Value>& x) {
  return std::abs(leading(x.value));
}

template <class Value>
[[nodiscard]] bool is_exactly_zero(const NumberBall<Value>& x) {
  return leading(x.value) == 0 && x.radius == 0;
}

}  // namespace detail

[[nodiscard]] inline double inflated(double radius) { return radius * (1 + 0x1p-40); }

template <class Value>
[[nodiscard]] NumberBall<Value> operator+(const NumberBall<Value>& x, const NumberBall<Value>& y) {
  NumberBall<Value> sum{x.value + y.value, x.radius + y.radius};
  sum.radius += detail::Rounding<Value>::sum * detail::magnitude(sum);
  return sum;
}

template <class Value>
[[nodiscard]] NumberBall<Value> operator-(const NumberBall<Value>& x, const NumberBall<Value>& y) {
  NumberBall<Value> difference{x.value - y.value, x.radius + y.radius};
  difference.radius += detail::Rounding<Value>::sum * detail::magnitude(difference);
  return difference;
}

/// What underflows, in the product or its radius, loses less than the guard. Zero stays exact in DoubleDoubles, so that
/// a crossing with a line along an axis is known to lie on it.
template <class Value>
[[nodiscard]] NumberBall<Value> operator*(const NumberBall<Value>& x, const NumberBall<Value>& y) {
  if constexpr (std::is_same_v<Value, DoubleDouble>) {
    if (detail::is_exactly_zero(x)) return x;
    if (detail::is_exactly_zero(y)) return y;
  }
  NumberBall<Value> product{x.value * y.value, 0};
  product.radius = detail::magnitude(x) * y.radius + (detail::magnitude(y) + y.radius) * x.radius +
                   (detail::Rounding<Value>::product * detail::magnitude(product) + detail::underflow_guard);
  return product;
}

/// The quotient; its radius comes from the remainder x - q y, whatever the roundings of q were: the error of q is the
/// remainder divided by y, and |y| >= |y.value| / 2 if the radius of y is below a quarter of that.
[[nodiscard]] inline NumberBall<DoubleDouble> operator/(const NumberBall<DoubleDouble>& x,
                                                        const NumberBall<DoubleDouble>& y) {
  if (detail::is_exactly_zero(x)) return x;
  const double divisor = y.value.high;
  const auto remainder = [&](DoubleDouble q) { return x - y * NumberBall<DoubleDouble>{q, 0}; };
  const double first = x.value.high / divisor;
  const double second = remainder({{first, 0}}).value.high / divisor;
  const DoubleDouble quotient{two_sum(first, second)};
  const NumberBall<DoubleDouble> rest = remainder(quotient);
  if (!(y.radius < std::abs(divisor) / 4)) return {quotient, std::numeric_limits<double>::infinity()};
  return {quotient, (detail::magnitude(rest) * (1 + 0x1p-50) + rest.radius) / (std::abs(divisor) / 2) +
                        detail::underflow_guard};
}

/// The sign, unless 0 is in the ball or not known not to be.
template <class Value>
[[nodiscard]] FilteredSign certain_sign(const NumberBall<Value>& x) {
  if (detail::magnitude(x) > inflated(x.radius)) return FilteredSign(sign_of(detail::leading(x.value)));
  return {};
}

}  // namespace leonhard::kernel
