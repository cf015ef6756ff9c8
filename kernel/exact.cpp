// SPDX-License-Identifier: MIT
#include "leonhard/kernel/exact.hpp"

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

mpq_class area2(std::span<const Point2> polygon) {
  mpq_class sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += cross(difference(polygon[i - 1], polygon[0]), difference(polygon[i], polygon[0]));
  return sum;
}

}  // namespace leonhard::kernel::exact
