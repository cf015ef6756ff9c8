// SPDX-License-Identifier: MIT
#include "leonhard/kernel/exact_implicit.hpp"

namespace leonhard::kernel::exact {
namespace {

/// The line of all (x, y) with a x + b y = c.
struct Line {
  mpq_class a, b, c;
};

Line line(const Point2& p, const Point2& q) {
  const RationalPoint2 u = rational(p), v = rational(q);
  return {u.y - v.y, v.x - u.x, v.x * u.y - u.x * v.y};
}

}  // namespace

RationalPoint2 rational(const Point2& p) { return {mpq_class(p.x), mpq_class(p.y)}; }

bool lines_cross(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Line l = line(a, b), m = line(c, d);
  return l.a * m.b != l.b * m.a;
}

RationalPoint2 line_crossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Line l = line(a, b), m = line(c, d);
  const mpq_class determinant = l.a * m.b - l.b * m.a;
  return {(l.c * m.b - l.b * m.c) / determinant, (l.a * m.c - l.c * m.a) / determinant};
}

Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
  const mpq_class area2 = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
  return sign_of(area2);
}

Sign incircle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
              const RationalPoint2& d) {
  const auto minor = [&d](const RationalPoint2& p, const RationalPoint2& q) {
    return mpq_class((p.x - d.x) * (q.y - d.y) - (p.y - d.y) * (q.x - d.x));
  };
  const auto square = [&d](const RationalPoint2& p) {
    return mpq_class((p.x - d.x) * (p.x - d.x) + (p.y - d.y) * (p.y - d.y));
  };
  const mpq_class determinant = square(a) * minor(b, c) + square(b) * minor(c, a) + square(c) * minor(a, b);
  return sign_of(determinant);
}

Sign compare_xy(const RationalPoint2& a, const RationalPoint2& b) {
  const int x = cmp(a.x, b.x);
  return sign_of(x != 0 ? x : cmp(a.y, b.y));
}

}  // namespace leonhard::kernel::exact
