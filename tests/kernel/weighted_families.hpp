// SPDX-License-Identifier: MIT
#pragma once

#include <cfloat>

#include "leonhard/kernel/weighted_point.hpp"
#include "tests/kernel/point_families.hpp"
#include "tests/kernel/point_families3.hpp"

/// Weights for drawn points, chosen to hurt the predicates of power.hpp.
namespace leonhard::testing {

using WeightedQuadruple = std::array<WeightedPoint2, 4>;
using WeightedQuintuple = std::array<WeightedPoint3, 5>;

inline WeightedPoint2 weighted(const Point2& p, double weight) { return {p, weight}; }
inline WeightedPoint3 weighted(const Point3& p, double weight) { return {p, weight}; }

inline double largest_coordinate(const Point2& p) { return std::fmax(std::abs(p.x), std::abs(p.y)); }
inline double largest_coordinate(const Point3& p) {
  return std::fmax(largest_coordinate(Point2{p.x, p.y}), std::abs(p.z));
}

/// A linear function of a point, of integer coefficients between -2 and 2.
struct Plane {
  explicit Plane(Random& random)
      : x(integer(random, -2, 2)), y(integer(random, -2, 2)), z(integer(random, -2, 2)) {}
  [[nodiscard]] double operator()(const Point2& p) const { return x * p.x + y * p.y; }
  [[nodiscard]] double operator()(const Point3& p) const { return x * p.x + y * p.y + z * p.z; }
  double x, y, z;
};

inline double squared_length(const Point2& p) { return p.x * p.x + p.y * p.y; }
inline double squared_length(const Point3& p) { return p.x * p.x + p.y * p.y + p.z * p.z; }

inline double clamped(double weight) {
  return std::isnan(weight) ? 0 : std::clamp(weight, -DBL_MAX, DBL_MAX);
}

/// The number of ways in which weigh chooses weights.
inline constexpr int weight_kinds = 8;

/// Gives weights to points: 0 all zero, 1 squares of coordinates' sizes, 2 any number of that size, 3 lifted
/// points that lie in one plane but for rounding, so that nearly all tests are ties or nearly so, 4 small
/// integers, 5 tiny, 6 huge, 7 of any exponent.
template <class Point, std::size_t Count>
auto weigh(Random& random, const std::array<Point, Count>& points, int kind) {
  const Plane plane(random);
  double size = 0;
  for (const Point& p : points) size = std::fmax(size, largest_coordinate(p));
  std::array<decltype(weighted(points[0], 0)), Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    const Point& p = points[i];
    double weight = 0;
    switch (kind) {
      case 0:
        break;
      case 1:
        weight = largest_coordinate(p) * largest_coordinate(p);
        break;
      case 2:
        weight = uniform(random) * size * size;
        break;
      case 3:
        weight = squared_length(p) - size * plane(p);
        if (integer(random, 0, 3) == 0) weight = nudge(random, weight);
        break;
      case 4:
        weight = integer(random, -4, 4);
        break;
      case 5:
        weight = any_exponent(random, -1080, -1000);
        break;
      case 6:
        weight = uniform(random) * DBL_MAX;
        break;
      default:
        weight = any_exponent(random, -1074, 1024);
    }
    result[i] = weighted(p, clamped(weight));
  }
  return result;
}

template <class Point, std::size_t Count>
auto with_equal_weights(const std::array<Point, Count>& points, double weight) {
  std::array<decltype(weighted(points[0], 0)), Count> result;
  for (std::size_t i = 0; i < Count; ++i) result[i] = weighted(points[i], weight);
  return result;
}

template <class WeightedPoint, std::size_t Count>
auto points_of(const std::array<WeightedPoint, Count>& weighted_points) {
  std::array<decltype(WeightedPoint::point), Count> points;
  for (std::size_t i = 0; i < Count; ++i) points[i] = weighted_points[i].point;
  return points;
}

/// Points and weights as C++ source.
template <class WeightedPoint, std::size_t Count>
std::string as_source(const std::array<WeightedPoint, Count>& weighted_points) {
  std::string source = as_source(points_of(weighted_points)) + "weights ";
  for (const WeightedPoint& p : weighted_points) {
    char text[40];
    std::snprintf(text, sizeof text, "%a, ", p.weight);
    source += text;
  }
  return source;
}

}  // namespace leonhard::testing
