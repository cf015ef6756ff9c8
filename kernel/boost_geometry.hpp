// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <boost/geometry/core/access.hpp>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/core/tags.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <boost/geometry/geometries/segment.hpp>

#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/predicates.hpp"

// Point2 and Point3 are points of Boost.Geometry: its algorithms and its R-tree take ours as they are. They round,
// so they may search, measure and draw, but never decide topology: that is for predicates.hpp, which the
// strategies below hand to the algorithms that take one.
BOOST_GEOMETRY_REGISTER_POINT_2D(leonhard::Point2, double, boost::geometry::cs::cartesian, x, y)
BOOST_GEOMETRY_REGISTER_POINT_3D(leonhard::Point3, double, boost::geometry::cs::cartesian, x, y, z)

namespace leonhard {

/// An axis-parallel box: min_corner() and max_corner() are Point2.
using Box2 = boost::geometry::model::box<Point2>;

/// A segment: first and second are Point2.
using Segment2 = boost::geometry::model::segment<Point2>;

/// An axis-parallel box of space: min_corner() and max_corner() are Point3.
using Box3 = boost::geometry::model::box<Point3>;

/// A segment of space: first and second are Point3.
using Segment3 = boost::geometry::model::segment<Point3>;

}  // namespace leonhard

namespace leonhard::kernel {

namespace detail {

/// Any plane point of Boost.Geometry as ours. The braces refuse coordinates that a double may not hold.
template <class BoostPoint>
[[nodiscard]] Point2 to_point2(const BoostPoint& p) {
  return {boost::geometry::get<0>(p), boost::geometry::get<1>(p)};
}

}  // namespace detail

/// Boost.Geometry's strategy for equality of points, without its epsilon: all coordinates are equal.
struct ExactPointEquality {
  using cs_tag = boost::geometry::cartesian_tag;

  template <class P, class Q>
  [[nodiscard]] static bool apply(const P& p, const Q& q) {
    return detail::to_point2(p) == detail::to_point2(q);
  }
};

/// Boost.Geometry's side strategy on orient2d. Its own, side_by_triangle, rounds, takes all within 2.2e-16 (a fixed
/// area) of the line as on it, and overflows.
///
///   boost::geometry::model::ring<Point2> ring{{0, 0}, {0, 1e-9}, {1e-9, 0}, {0, 0}};
///   bool convex = boost::geometry::is_convex(ring, leonhard::kernel::ExactSide{});
///   bool inside = boost::geometry::within(Point2{1e-10, 1e-10}, ring, leonhard::kernel::ExactWinding{});
///
/// is_convex needs <boost/geometry/algorithms/is_convex.hpp>. Coordinates are float or double. convex_hull of
/// Boost before 1.76 and all overlays (intersection, union_) take no side strategy.
struct ExactSide {
  using cs_tag = boost::geometry::cartesian_tag;
  using equals_point_point_strategy_type = ExactPointEquality;

  [[nodiscard]] static ExactPointEquality get_equals_point_point_strategy() { return {}; }

  /// returns  1 if p lies left of the line ab, 0 on it, -1 right of it
  /// throws   InputError if a coordinate is not finite
  template <class A, class B, class P>
  [[nodiscard]] static int apply(const A& a, const B& b, const P& p) {
    return static_cast<int>(orient2d(detail::to_point2(a), detail::to_point2(b), detail::to_point2(p)));
  }
};

/// Boost.Geometry's strategy for points in rings, polygons, lines and segments, on ExactSide: for within and
/// covered_by. Counts the edges that cross the ray from the point to the right; an edge owns its lower end, not its
/// upper one, so a ray through a corner counts once. Any orientation; self-crossing rings by nonzero winding.
/// Method: Hormann and Agathos, Computational Geometry 20 (2001), "The point in polygon problem for arbitrary
/// polygons".
struct ExactWinding {
  using cs_tag = boost::geometry::cartesian_tag;
  using equals_point_point_strategy_type = ExactPointEquality;

  [[nodiscard]] static ExactPointEquality get_equals_point_point_strategy() { return {}; }

  struct state_type {
    int winding_number = 0;
    bool on_edge = false;
  };

  /// Adds the edge ab to the state of p.
  ///
  /// returns  false once the answer is known: p lies on ab
  /// throws   InputError if a coordinate is not finite, unless the edge lies above or below p all the same
  template <class P, class A>
  [[nodiscard]] static bool apply(const P& point, const A& first, const A& second, state_type& state) {
    const Point2 p = detail::to_point2(point), a = detail::to_point2(first), b = detail::to_point2(second);
    const bool a_is_above = a.y > p.y, b_is_above = b.y > p.y;
    if ((a_is_above && b_is_above) || (a.y < p.y && b.y < p.y)) return true;

    const Sign side = orient2d(a, b, p);
    if (side == Sign::zero && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)) state.on_edge = true;
    if (!a_is_above && b_is_above && side == Sign::positive) ++state.winding_number;
    if (a_is_above && !b_is_above && side == Sign::negative) --state.winding_number;
    return !state.on_edge;
  }

  /// returns  1 if the point lies inside, 0 on an edge, -1 outside
  [[nodiscard]] static int result(const state_type& state) {
    return state.on_edge ? 0 : state.winding_number != 0 ? 1 : -1;
  }
};

}  // namespace leonhard::kernel

// From 1.76 on Boost takes a single strategy only after turning it into a bundle of all that the algorithm asks for.
#if __has_include(<boost/geometry/strategies/is_convex/services.hpp>)
#include <boost/geometry/strategies/detail.hpp>
#include <boost/geometry/strategies/is_convex/services.hpp>
#include <boost/geometry/strategies/relate/services.hpp>
#include <boost/geometry/util/type_traits.hpp>

namespace leonhard::kernel {

/// Our strategies as a bundle, for convex_hull too.
struct ExactStrategies : boost::geometry::strategies::detail::cartesian_base {
  [[nodiscard]] static ExactSide side() { return {}; }

  template <class P, class G>
  [[nodiscard]] static auto relate(const P&, const G&) {
    if constexpr (boost::geometry::util::is_pointlike<G>::value)
      return ExactPointEquality{};
    else
      return ExactWinding{};
  }
};

}  // namespace leonhard::kernel

template <>
struct boost::geometry::strategies::is_convex::services::strategy_converter<leonhard::kernel::ExactSide> {
  static auto get(const leonhard::kernel::ExactSide&) { return leonhard::kernel::ExactStrategies{}; }
};

template <>
struct boost::geometry::strategies::relate::services::strategy_converter<leonhard::kernel::ExactWinding> {
  static auto get(const leonhard::kernel::ExactWinding&) { return leonhard::kernel::ExactStrategies{}; }
};
#endif
