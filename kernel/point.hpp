// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>

namespace leonhard {

/// A point of the plane. Comparison is lexicographic (x, then y), exact, and takes -0 and +0 as equal: the order
/// on which every symbolic perturbation rests.
struct Point2 {
  double x{};
  double y{};

  friend constexpr bool operator==(const Point2&, const Point2&) = default;
  friend constexpr std::partial_ordering operator<=>(const Point2&, const Point2&) = default;
};

/// A vector of the plane: a difference of points, a normal, a gradient.
struct Vec2 {
  double x{};
  double y{};

  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

[[nodiscard]] constexpr Vec2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] constexpr Point2 operator+(Point2 p, Vec2 v) { return {p.x + v.x, p.y + v.y}; }
[[nodiscard]] constexpr Vec2 operator+(Vec2 u, Vec2 v) { return {u.x + v.x, u.y + v.y}; }
[[nodiscard]] constexpr Vec2 operator-(Vec2 u, Vec2 v) { return {u.x - v.x, u.y - v.y}; }
[[nodiscard]] constexpr Vec2 operator-(Vec2 u) { return {-u.x, -u.y}; }
[[nodiscard]] constexpr Vec2 operator*(double s, Vec2 v) { return {s * v.x, s * v.y}; }
[[nodiscard]] constexpr double dot(Vec2 u, Vec2 v) { return u.x * v.x + u.y * v.y; }
[[nodiscard]] constexpr double cross(Vec2 u, Vec2 v) { return u.x * v.y - u.y * v.x; }
[[nodiscard]] inline double norm(Vec2 v) { return std::hypot(v.x, v.y); }
[[nodiscard]] inline double distance(Point2 a, Point2 b) { return norm(a - b); }
[[nodiscard]] inline bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace leonhard
