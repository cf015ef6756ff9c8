// SPDX-License-Identifier: MIT
#pragma once

#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <boost/geometry/geometries/segment.hpp>

#include "leonhard/kernel/point.hpp"

// Point2 is a point of Boost.Geometry: its algorithms and its R-tree take ours as they are. They round, so
// they may search, measure and draw, but never decide topology: that is for predicates.hpp.
BOOST_GEOMETRY_REGISTER_POINT_2D(leonhard::Point2, double, boost::geometry::cs::cartesian, x, y)

namespace leonhard {

/// An axis-parallel box: min_corner() and max_corner() are Point2.
using Box2 = boost::geometry::model::box<Point2>;

/// A segment: first and second are Point2.
using Segment2 = boost::geometry::model::segment<Point2>;

}  // namespace leonhard
