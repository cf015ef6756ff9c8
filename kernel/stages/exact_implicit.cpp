// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/exact_implicit.hpp"

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

std::optional<RationalPoint2> line_crossing(const Point2& a, const Point2& b, const Point2& c,
                                            const Point2& d) {
  const Line l = line(a, b), m = line(c, d);
  const mpq_class determinant = l.a * m.b - l.b * m.a;
  if (determinant == 0) return {};
  return RationalPoint2{(l.c * m.b - l.b * m.c) / determinant, (l.a * m.c - l.c * m.a) / determinant};
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

// ---- space ----

namespace {

/// The determinant with the given rows.
mpq_class determinant(const RationalPoint3& u, const RationalPoint3& v, const RationalPoint3& w) {
  return u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
}

RationalPoint3 difference(const RationalPoint3& a, const RationalPoint3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// a x + b y + c z - d: 0 on the plane.
mpq_class height(const RationalPlane& l, const RationalPoint3& p) {
  return l.a * p.x + l.b * p.y + l.c * p.z - l.d;
}

}  // namespace

RationalPoint3 rational(const Point3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

RationalPlane plane(const Point3& p, const Point3& q, const Point3& r) {
  const RationalPoint3 base = rational(p), u = difference(rational(q), base),
                       v = difference(rational(r), base);
  RationalPlane l{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x, 0};
  l.d = height(l, base);
  return l;
}

std::optional<RationalPoint3> line_plane_crossing(const Point3& p, const Point3& q,
                                                  const RationalPlane& plane) {
  const RationalPoint3 u = rational(p), v = rational(q);
  const mpq_class at_u = height(plane, u), at_v = height(plane, v);
  if (at_u == at_v) return {};
  // The heights are in proportion to the distances from the crossing.
  const auto between = [&](const mpq_class& of_u, const mpq_class& of_v) {
    return mpq_class((of_u * at_v - of_v * at_u) / (at_v - at_u));
  };
  return RationalPoint3{between(u.x, v.x), between(u.y, v.y), between(u.z, v.z)};
}

std::optional<RationalPoint3> three_plane_crossing(const RationalPlane& l, const RationalPlane& m,
                                                   const RationalPlane& n) {
  const mpq_class whole = determinant({l.a, l.b, l.c}, {m.a, m.b, m.c}, {n.a, n.b, n.c});
  if (whole == 0) return {};
  return RationalPoint3{determinant({l.d, l.b, l.c}, {m.d, m.b, m.c}, {n.d, n.b, n.c}) / whole,
                        determinant({l.a, l.d, l.c}, {m.a, m.d, m.c}, {n.a, n.d, n.c}) / whole,
                        determinant({l.a, l.b, l.d}, {m.a, m.b, m.d}, {n.a, n.b, n.d}) / whole};
}

Sign orient3d(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d) {
  return sign_of(determinant(difference(b, a), difference(c, a), difference(d, a)));
}

Sign insphere(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d, const RationalPoint3& e) {
  const RationalPoint3 u = difference(a, e), v = difference(b, e), w = difference(c, e), t = difference(d, e);
  const auto square = [](const RationalPoint3& p) { return mpq_class(p.x * p.x + p.y * p.y + p.z * p.z); };
  const mpq_class lifted = square(u) * determinant(v, w, t) - square(v) * determinant(u, w, t) +
                           square(w) * determinant(u, v, t) - square(t) * determinant(u, v, w);
  return sign_of(lifted);
}

Sign compare_xyz(const RationalPoint3& a, const RationalPoint3& b) {
  const int x = cmp(a.x, b.x), y = cmp(a.y, b.y);
  return sign_of(x != 0 ? x : y != 0 ? y : cmp(a.z, b.z));
}

}  // namespace leonhard::kernel::exact
