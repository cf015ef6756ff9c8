// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <optional>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/sign.hpp"

/// Intersections of lines and planes, and predicates of points with rational coordinates, in GMP's rational numbers
/// straight from their definitions: the oracle of tests and fuzzers for implicit_point.hpp,
/// with which it shares no formula. Same sign conventions.
namespace leonhard::kernel::exact {

struct RationalPoint2 {
  mpq_class x, y;
};

[[nodiscard]] RationalPoint2 rational(const Point2& p);

/// The one point that the lines ab and cd have in common, if there is one.
[[nodiscard]] std::optional<RationalPoint2> line_crossing(const Point2& a, const Point2& b, const Point2& c,
                                                          const Point2& d);

[[nodiscard]] Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c);
[[nodiscard]] Sign incircle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
                            const RationalPoint2& d);
[[nodiscard]] Sign compare_xy(const RationalPoint2& a, const RationalPoint2& b);

// ---- space ----

struct RationalPoint3 {
  mpq_class x, y, z;
};

/// The plane of all (x, y, z) with a x + b y + c z = d.
struct RationalPlane {
  mpq_class a, b, c, d;
};

[[nodiscard]] RationalPoint3 rational(const Point3& p);

/// The plane through p, q, r; a = b = c = 0 if they are collinear.
[[nodiscard]] RationalPlane plane(const Point3& p, const Point3& q, const Point3& r);

/// The one point that the line pq and the plane have in common, if there is one.
[[nodiscard]] std::optional<RationalPoint3> line_plane_crossing(const Point3& p, const Point3& q,
                                                                const RationalPlane& plane);

/// The one point that three planes have in common, if there is one.
[[nodiscard]] std::optional<RationalPoint3> three_plane_crossing(const RationalPlane& l,
                                                                 const RationalPlane& m,
                                                                 const RationalPlane& n);

[[nodiscard]] Sign orient3d(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
                            const RationalPoint3& d);
[[nodiscard]] Sign insphere(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
                            const RationalPoint3& d, const RationalPoint3& e);
[[nodiscard]] Sign compare_xyz(const RationalPoint3& a, const RationalPoint3& b);

}  // namespace leonhard::kernel::exact
