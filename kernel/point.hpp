// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>
#include <cstddef>
#include <iosfwd>
#include <string_view>  // std::hash

namespace leonhard {

/// Points and vectors are two kinds: a difference of points is a vector, and a point moves by a vector. Sums and products
/// are those of doubles, rounded; what must be exact is asked of the predicates.

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
[[nodiscard]] constexpr Point2 operator-(Point2 p, Vec2 v) { return {p.x - v.x, p.y - v.y}; }
[[nodiscard]] constexpr Vec2 operator+(Vec2 u, Vec2 v) { return {u.x + v.x, u.y + v.y}; }
[[nodiscard]] constexpr Vec2 operator-(Vec2 u, Vec2 v) { return {u.x - v.x, u.y - v.y}; }
[[nodiscard]] constexpr Vec2 operator-(Vec2 u) { return {-u.x, -u.y}; }
[[nodiscard]] constexpr Vec2 operator*(double s, Vec2 v) { return {s * v.x, s * v.y}; }
[[nodiscard]] constexpr Vec2 operator*(Vec2 v, double s) { return s * v; }
[[nodiscard]] constexpr Vec2 operator/(Vec2 v, double s) { return {v.x / s, v.y / s}; }
constexpr Point2& operator+=(Point2& p, Vec2 v) { return p = p + v; }
constexpr Point2& operator-=(Point2& p, Vec2 v) { return p = p - v; }
constexpr Vec2& operator+=(Vec2& u, Vec2 v) { return u = u + v; }
constexpr Vec2& operator-=(Vec2& u, Vec2 v) { return u = u - v; }
constexpr Vec2& operator*=(Vec2& v, double s) { return v = s * v; }
constexpr Vec2& operator/=(Vec2& v, double s) { return v = v / s; }
[[nodiscard]] constexpr double dot(Vec2 u, Vec2 v) { return u.x * v.x + u.y * v.y; }
[[nodiscard]] constexpr double cross(Vec2 u, Vec2 v) { return u.x * v.y - u.y * v.x; }
[[nodiscard]] inline double norm(Vec2 v) { return std::hypot(v.x, v.y); }
[[nodiscard]] inline double distance(Point2 a, Point2 b) { return norm(a - b); }
[[nodiscard]] inline bool is_finite(Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// A point of space. Comparison as for Point2: lexicographic (x, then y, then z), exact, -0 equal to +0.
struct Point3 {
  double x{};
  double y{};
  double z{};

  friend constexpr bool operator==(const Point3&, const Point3&) = default;
  friend constexpr std::partial_ordering operator<=>(const Point3&, const Point3&) = default;
};

/// A vector of space.
struct Vec3 {
  double x{};
  double y{};
  double z{};

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

[[nodiscard]] constexpr Vec3 operator-(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] constexpr Point3 operator+(const Point3& p, const Vec3& v) {
  return {p.x + v.x, p.y + v.y, p.z + v.z};
}
[[nodiscard]] constexpr Point3 operator-(const Point3& p, const Vec3& v) {
  return {p.x - v.x, p.y - v.y, p.z - v.z};
}
[[nodiscard]] constexpr Vec3 operator+(const Vec3& u, const Vec3& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
[[nodiscard]] constexpr Vec3 operator-(const Vec3& u, const Vec3& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
[[nodiscard]] constexpr Vec3 operator-(const Vec3& u) { return {-u.x, -u.y, -u.z}; }
[[nodiscard]] constexpr Vec3 operator*(double s, const Vec3& v) { return {s * v.x, s * v.y, s * v.z}; }
[[nodiscard]] constexpr Vec3 operator*(const Vec3& v, double s) { return s * v; }
[[nodiscard]] constexpr Vec3 operator/(const Vec3& v, double s) { return {v.x / s, v.y / s, v.z / s}; }
constexpr Point3& operator+=(Point3& p, const Vec3& v) { return p = p + v; }
constexpr Point3& operator-=(Point3& p, const Vec3& v) { return p = p - v; }
constexpr Vec3& operator+=(Vec3& u, const Vec3& v) { return u = u + v; }
constexpr Vec3& operator-=(Vec3& u, const Vec3& v) { return u = u - v; }
constexpr Vec3& operator*=(Vec3& v, double s) { return v = s * v; }
constexpr Vec3& operator/=(Vec3& v, double s) { return v = v / s; }
[[nodiscard]] constexpr double dot(const Vec3& u, const Vec3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
[[nodiscard]] constexpr Vec3 cross(const Vec3& u, const Vec3& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
[[nodiscard]] inline double norm(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }
[[nodiscard]] inline double distance(const Point3& a, const Point3& b) { return norm(a - b); }
[[nodiscard]] inline bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Writes "(0.5, 1)": the shortest decimals that read back as the same doubles, whatever the stream's precision.
std::ostream& operator<<(std::ostream& out, Point2 p);
std::ostream& operator<<(std::ostream& out, Vec2 v);
std::ostream& operator<<(std::ostream& out, const Point3& p);
std::ostream& operator<<(std::ostream& out, const Vec3& v);

}  // namespace leonhard

/// Equal points have equal hashes: -0 and +0 count as one.
template <>
struct std::hash<leonhard::Point2> {
  [[nodiscard]] std::size_t operator()(leonhard::Point2 p) const noexcept {
    const std::hash<double> of;
    return of(p.x) * 0x9e3779b97f4a7c15U + of(p.y);
  }
};
template <>
struct std::hash<leonhard::Point3> {
  [[nodiscard]] std::size_t operator()(const leonhard::Point3& p) const noexcept {
    return std::hash<leonhard::Point2>()({p.x, p.y}) * 0x9e3779b97f4a7c15U + std::hash<double>()(p.z);
  }
};
