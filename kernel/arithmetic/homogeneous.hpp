// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include "leonhard/kernel/arithmetic/exact_range.hpp"
#include "leonhard/kernel/point.hpp"

/// Intersections of lines and planes in homogeneous coordinates, and determinants, over any kind of numbers: balls,
/// expansions, integers. `Numbers` is a type as described in exact_numbers.hpp.
///
/// A point is given by its defining points, whose number tells which it is:
///   of the plane   1  the point itself
///                  4  a, b, c, d: where the lines ab and cd cross
///   of space       1  the point itself
///                  5  p, q, r, s, t: where the line pq crosses the plane rst
///                  9  three times p, q, r: where three planes pqr cross
namespace leonhard::kernel {

template <class Point>
inline constexpr std::size_t dimension = std::tuple_size_v<decltype(coordinates(std::declval<Point&>()))>;

[[nodiscard]] inline double coordinate(const Point2& p, std::size_t axis) { return axis == 0 ? p.x : p.y; }
[[nodiscard]] inline double coordinate(const Point3& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

template <class Number, std::size_t Size>
using Vector = std::array<Number, Size>;

// ---- vectors and determinants ----

template <class Number, std::size_t Size>
[[nodiscard]] Number dot(const Vector<Number, Size>& u, const Vector<Number, Size>& v) {
  Number sum = u[0] * v[0];
  for (std::size_t i = 1; i < Size; ++i) sum = sum + u[i] * v[i];
  return sum;
}

template <class Number>
[[nodiscard]] Number cross(const Vector<Number, 2>& u, const Vector<Number, 2>& v) {
  return u[0] * v[1] - u[1] * v[0];
}

template <class Number>
[[nodiscard]] Vector<Number, 3> cross(const Vector<Number, 3>& u, const Vector<Number, 3>& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

template <class Number>
[[nodiscard]] Number determinant(const std::array<Vector<Number, 2>, 2>& rows) {
  return cross(rows[0], rows[1]);
}

template <class Number>
[[nodiscard]] Number determinant(const std::array<Vector<Number, 3>, 3>& rows) {
  return dot(cross(rows[0], rows[1]), rows[2]);
}

/// By the minors of the first two columns and those of the last two.
template <class Number>
[[nodiscard]] Number determinant(const std::array<Vector<Number, 4>, 4>& rows) {
  const auto left = [&rows](std::size_t i, std::size_t j) -> Number {
    return rows[i][0] * rows[j][1] - rows[i][1] * rows[j][0];
  };
  const auto right = [&rows](std::size_t i, std::size_t j) -> Number {
    return rows[i][2] * rows[j][3] - rows[i][3] * rows[j][2];
  };
  const Number first = left(0, 1) * right(2, 3) + left(2, 3) * right(0, 1);
  const Number second = left(0, 2) * right(1, 3) + left(1, 3) * right(0, 2);
  const Number third = left(0, 3) * right(1, 2) + left(1, 2) * right(0, 3);
  return first - second + third;
}

// ---- homogeneous coordinates ----

/// The point base + offset / weight; if it is explicit, base alone, and offset is 0, weight 1.
template <class Number, class Point>
struct Homogeneous {
  Point base;
  Vector<Number, dimension<Point>> offset;
  Number weight;
  bool is_explicit = false;
};

/// The degree of weight; that of an offset is one more.
[[nodiscard]] constexpr int weight_degree(std::size_t defining_points) {
  switch (defining_points) {
    case 1:
      return 0;
    case 4:
      return 2;
    case 5:
      return 3;
    default:
      return 6;
  }
}

template <class Numbers>
[[nodiscard]] Vector<typename Numbers::Number, 2> difference(const Numbers& numbers, const Point2& a,
                                                             const Point2& b) {
  return {numbers.difference(a.x, b.x), numbers.difference(a.y, b.y)};
}

template <class Numbers>
[[nodiscard]] Vector<typename Numbers::Number, 3> difference(const Numbers& numbers, const Point3& a,
                                                             const Point3& b) {
  return {numbers.difference(a.x, b.x), numbers.difference(a.y, b.y), numbers.difference(a.z, b.z)};
}

/// a + t (b - a) lies on the line cd if t (b - a) x (d - c) = (c - a) x (d - c).
template <class Numbers>
[[nodiscard]] auto line_crossing(const Numbers& numbers, std::span<const Point2> defining) {
  const Point2 &a = defining[0], &b = defining[1], &c = defining[2], &d = defining[3];
  using Number = typename Numbers::Number;
  const auto along = difference(numbers, b, a), other = difference(numbers, d, c);
  const Number step = cross(difference(numbers, c, a), other);
  return Homogeneous<Number, Point2>{a, {step * along[0], step * along[1]}, cross(along, other)};
}

template <class Numbers>
[[nodiscard]] Vector<typename Numbers::Number, 3> normal(const Numbers& numbers, const Point3& p,
                                                         const Point3& q, const Point3& r) {
  return cross(difference(numbers, q, p), difference(numbers, r, p));
}

/// p + t (q - p) lies in the plane through r of normal n if t n . (q - p) = n . (r - p).
template <class Numbers>
[[nodiscard]] auto line_plane_crossing(const Numbers& numbers, std::span<const Point3> defining) {
  const Point3 &p = defining[0], &q = defining[1], &r = defining[2];
  using Number = typename Numbers::Number;
  const auto n = normal(numbers, r, defining[3], defining[4]);
  const auto along = difference(numbers, q, p);
  const Number step = dot(n, difference(numbers, r, p));
  return Homogeneous<Number, Point3>{p, {step * along[0], step * along[1], step * along[2]}, dot(n, along)};
}

/// The offset x from a point of the first plane has n1 . x = 0, n2 . x = d2, n3 . x = d3, so by Cramer's rule x is
/// (d2 (n3 x n1) + d3 (n1 x n2)) / (n1 . (n2 x n3)).
template <class Numbers>
[[nodiscard]] auto three_plane_crossing(const Numbers& numbers, std::span<const Point3> defining) {
  using Number = typename Numbers::Number;
  const auto normal_of = [&](std::size_t plane) {
    return normal(numbers, defining[3 * plane], defining[3 * plane + 1], defining[3 * plane + 2]);
  };
  const auto n1 = normal_of(0), n2 = normal_of(1), n3 = normal_of(2);
  const Number d2 = dot(n2, difference(numbers, defining[3], defining[0]));
  const Number d3 = dot(n3, difference(numbers, defining[6], defining[0]));
  const auto n31 = cross(n3, n1), n12 = cross(n1, n2);
  const auto offset = [&](std::size_t i) -> Number { return d2 * n31[i] + d3 * n12[i]; };
  return Homogeneous<Number, Point3>{defining[0], {offset(0), offset(1), offset(2)}, dot(n12, n3)};
}

template <class Numbers>
[[nodiscard]] Homogeneous<typename Numbers::Number, Point2> homogeneous(const Numbers& numbers,
                                                                        std::span<const Point2> defining) {
  if (defining.size() == 4) return line_crossing(numbers, defining);
  return {defining[0], {}, numbers.one(), true};
}

template <class Numbers>
[[nodiscard]] Homogeneous<typename Numbers::Number, Point3> homogeneous(const Numbers& numbers,
                                                                        std::span<const Point3> defining) {
  if (defining.size() == 5) return line_plane_crossing(numbers, defining);
  if (defining.size() == 9) return three_plane_crossing(numbers, defining);
  return {defining[0], {}, numbers.one(), true};
}

/// The vector from a reference point to a point, times `weight`.
template <class Number, std::size_t Dimension>
struct WeightedVector {
  Vector<Number, Dimension> vector;
  Number weight;
};

template <class Numbers, class Point>
[[nodiscard]] auto weighted_vector(const Numbers& numbers,
                                   const Homogeneous<typename Numbers::Number, Point>& reference,
                                   const Homogeneous<typename Numbers::Number, Point>& p) {
  using Number = typename Numbers::Number;
  const auto shift = difference(numbers, p.base, reference.base);
  const auto component = [&](std::size_t i) -> Number {
    if (p.is_explicit && reference.is_explicit) return shift[i];
    if (reference.is_explicit) return shift[i] * p.weight + p.offset[i];
    if (p.is_explicit) return shift[i] * reference.weight - reference.offset[i];
    return (shift[i] * p.weight + p.offset[i]) * reference.weight - reference.offset[i] * p.weight;
  };
  WeightedVector<Number, dimension<Point>> v{{}, p.weight * reference.weight};
  for (std::size_t i = 0; i < v.vector.size(); ++i) v.vector[i] = component(i);
  return v;
}

}  // namespace leonhard::kernel
