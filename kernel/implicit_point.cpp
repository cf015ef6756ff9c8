// SPDX-License-Identifier: MIT
#include "leonhard/kernel/implicit_point.hpp"

#include <array>

#include "leonhard/kernel/arithmetic/rounded_coordinates.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/stages/staged_predicate.hpp"

namespace leonhard::kernel {

LineCrossing::LineCrossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
    : ImplicitPoint({a, b, c, d}, {"LineCrossing", "lines are parallel, or the points of one are equal",
                                   "make crossings of segments that orient2d says to cross"}) {}

Sign orient2d(const PointRef2& a, const PointRef2& b, const PointRef2& c) {
  if (a.is_explicit() && b.is_explicit() && c.is_explicit())
    return orient2d(a.explicit_point(), b.explicit_point(), c.explicit_point());
  return orient2d_staged(a, b, c).sign;
}

Sign incircle(const PointRef2& a, const PointRef2& b, const PointRef2& c, const PointRef2& d) {
  if (a.is_explicit() && b.is_explicit() && c.is_explicit() && d.is_explicit())
    return incircle(a.explicit_point(), b.explicit_point(), c.explicit_point(), d.explicit_point());
  return incircle_staged(a, b, c, d).sign;
}

Sign compare_xy(const PointRef2& a, const PointRef2& b) { return compare_xy_staged(a, b).sign; }

StagedSign orient2d_staged(const PointRef2& a, const PointRef2& b, const PointRef2& c, Stage first) {
  return determinant_sign(std::array{a, b, c}, first);
}

StagedSign incircle_staged(const PointRef2& a, const PointRef2& b, const PointRef2& c, const PointRef2& d,
                           Stage first) {
  return determinant_sign(std::array{a, b, c, d}, first);
}

StagedSign compare_xy_staged(const PointRef2& a, const PointRef2& b, Stage first) {
  return lexicographic_sign(a, b, first);
}

RoundedPoint2 rounded(const PointRef2& p) {
  const auto [coordinates, error] = rounded_coordinates(p);
  return {{coordinates[0], coordinates[1]}, error};
}

}  // namespace leonhard::kernel
