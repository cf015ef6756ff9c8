// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

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

/// Do the lines ab and cd have exactly one point in common?
[[nodiscard]] bool lines_cross(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// The point where the lines ab and cd cross; they must.
[[nodiscard]] RationalPoint2 line_crossing(const Point2& a, const Point2& b, const Point2& c,
                                           const Point2& d);

[[nodiscard]] Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c);
[[nodiscard]] Sign incircle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
                            const RationalPoint2& d);
[[nodiscard]] Sign compare_xy(const RationalPoint2& a, const RationalPoint2& b);

}  // namespace leonhard::kernel::exact
