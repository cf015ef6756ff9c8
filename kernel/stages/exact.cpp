// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/exact.hpp"

#include <cstddef>

namespace leonhard::kernel::exact {
namespace {

struct ExactVec2 {
  mpq_class x, y;
};

ExactVec2 difference(Point2 a, Point2 b) {
  return {mpq_class(a.x) - mpq_class(b.x), mpq_class(a.y) - mpq_class(b.y)};
}

mpq_class dot(const ExactVec2& u, const ExactVec2& v) { return u.x * v.x + u.y * v.y; }
mpq_class cross(const ExactVec2& u, const ExactVec2& v) { return u.x * v.y - u.y * v.x; }

struct ExactVec3 {
  mpq_class x, y, z;
};

ExactVec3 difference(const Point3& a, const Point3& b) {
  return {mpq_class(a.x) - mpq_class(b.x), mpq_class(a.y) - mpq_class(b.y), mpq_class(a.z) - mpq_class(b.z)};
}

mpq_class dot(const ExactVec3& u, const ExactVec3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
ExactVec3 cross(const ExactVec3& u, const ExactVec3& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// The height of a above the paraboloid's tangent plane at the origin: |A|^2 less the difference of the weights.
template <class WeightedPoint>
mpq_class height(const WeightedPoint& a, const WeightedPoint& origin) {
  const auto v = difference(a.point, origin.point);
  return dot(v, v) - mpq_class(a.weight) + mpq_class(origin.weight);
}

}  // namespace

Sign orient2d(Point2 a, Point2 b, Point2 c) { return sign_of(cross(difference(a, c), difference(b, c))); }

Sign incircle(Point2 a, Point2 b, Point2 c, Point2 d) {
  const ExactVec2 u = difference(a, d), v = difference(b, d), w = difference(c, d);
  const mpq_class determinant = dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v);
  return sign_of(determinant);
}

Sign in_diametral_circle(Point2 p, Point2 a, Point2 b) {
  return -sign_of(dot(difference(a, p), difference(b, p)));
}

Sign compare_distance(Point2 p, Point2 a, Point2 b) {
  const ExactVec2 u = difference(a, p), v = difference(b, p);
  const mpq_class squares_difference = dot(u, u) - dot(v, v);
  return sign_of(squares_difference);
}

Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of(dot(cross(difference(b, a), difference(c, a)), difference(d, a)));
}

Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  const ExactVec3 u = difference(a, e), v = difference(b, e), w = difference(c, e), t = difference(d, e);
  const ExactVec3 uv = cross(u, v), wt = cross(w, t);
  const mpq_class determinant =
      dot(u, u) * dot(wt, v) - dot(v, v) * dot(wt, u) + dot(w, w) * dot(uv, t) - dot(t, t) * dot(uv, w);
  return sign_of(determinant);
}

Sign in_diametral_sphere(const Point3& p, const Point3& a, const Point3& b) {
  return -sign_of(dot(difference(a, p), difference(b, p)));
}

Sign compare_distance(const Point3& p, const Point3& a, const Point3& b) {
  const ExactVec3 u = difference(a, p), v = difference(b, p);
  const mpq_class squares_difference = dot(u, u) - dot(v, v);
  return sign_of(squares_difference);
}

Sign power_test(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                const WeightedPoint2& d) {
  const ExactVec2 u = difference(a.point, d.point), v = difference(b.point, d.point),
                  w = difference(c.point, d.point);
  const mpq_class determinant =
      height(a, d) * cross(v, w) + height(b, d) * cross(w, u) + height(c, d) * cross(u, v);
  return sign_of(determinant);
}

Sign power_test(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                const WeightedPoint3& d, const WeightedPoint3& e) {
  const ExactVec3 u = difference(a.point, e.point), v = difference(b.point, e.point),
                  w = difference(c.point, e.point), t = difference(d.point, e.point);
  const ExactVec3 uv = cross(u, v), wt = cross(w, t);
  const mpq_class determinant = height(a, e) * dot(wt, v) - height(b, e) * dot(wt, u) +
                                height(c, e) * dot(uv, t) - height(d, e) * dot(uv, w);
  return sign_of(determinant);
}

Sign compare_power_distance(const Point2& p, const WeightedPoint2& a, const WeightedPoint2& b) {
  const WeightedPoint2 origin{p, 0};
  return sign_of(mpq_class(height(a, origin) - height(b, origin)));
}

Sign compare_power_distance(const Point3& p, const WeightedPoint3& a, const WeightedPoint3& b) {
  const WeightedPoint3 origin{p, 0};
  return sign_of(mpq_class(height(a, origin) - height(b, origin)));
}

mpq_class area2(std::span<const Point2> polygon) {
  mpq_class sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += cross(difference(polygon[i - 1], polygon[0]), difference(polygon[i], polygon[0]));
  return sum;
}

}  // namespace leonhard::kernel::exact
