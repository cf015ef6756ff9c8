// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "leonhard/kernel/arithmetic/exact_numbers.hpp"
#include "leonhard/kernel/arithmetic/homogeneous.hpp"
#include "leonhard/kernel/arithmetic/nearest_double.hpp"
#include "leonhard/kernel/stages/finite.hpp"
#include "leonhard/kernel/stages/point_ref.hpp"

namespace leonhard::kernel {

/// The double to which all numbers of a ball round, if there is one. Rounding keeps order, so it is enough that both
/// ends do, moved outwards by a step each for the rounding of low - radius and low + radius.
[[nodiscard]] inline std::optional<double> certain_rounding(const NumberBall<DoubleDouble>& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto [high, low] = x.value;
  if (x.radius == 0) return high + low;
  if (high + std::nextafter(low - x.radius, -infinity) != high) return {};
  if (high + std::nextafter(low + x.radius, infinity) != high) return {};
  return high;
}

/// The double nearest to a coordinate; infinite from 2^1024 - 2^970 on in size.
template <class Point>
[[nodiscard]] double nearest_coordinate(std::span<const Point> defining, std::size_t axis) {
  BitRange bits;
  for (Point p : defining)
    for (const double* x : coordinates(p)) bits.include(*x);
  const Integers numbers{bits.lowest};
  const auto p = homogeneous(numbers, defining);
  const mpz_class base = numbers.integer(coordinate(p.base, axis));
  return nearest_double(base * p.weight + p.offset[axis], p.weight, numbers.unit);
}

template <class Point>
struct RoundedCoordinates {
  std::array<double, dimension<Point>> values;
  double error;
};

/// What `rounded` of implicit_point.hpp promises. A double x that is the nearest one to a number is within u |x| of it,
/// or within 2^-1075 if it is subnormal.
template <class Point>
[[nodiscard]] RoundedCoordinates<Point> rounded_coordinates(const PointRef<Point>& p) {
  constexpr double largest = std::numeric_limits<double>::max();
  if (p.is_explicit()) detail::require_finite("rounded", p.explicit_point());
  RoundedCoordinates<Point> rounded{{}, 0};
  const Coordinates<Point> balls = p.coordinates();
  for (std::size_t axis = 0; axis < balls.size(); ++axis) {
    const std::optional<double> certain = certain_rounding(balls[axis]);
    const double nearest = certain ? *certain : nearest_coordinate(p.defining_points(), axis);
    const bool is_exact = balls[axis].radius == 0 && balls[axis].value.low == 0;
    rounded.values[axis] = std::clamp(nearest, -largest, largest);
    if (std::isinf(nearest)) rounded.error = std::abs(nearest);
    if (!is_exact)
      rounded.error =
          std::max({rounded.error, 0x1p-53 * std::abs(nearest), std::numeric_limits<double>::denorm_min()});
  }
  return rounded;
}

}  // namespace leonhard::kernel
