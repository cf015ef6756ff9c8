// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/app/geometry/curve.hpp"

namespace leonhard::app {

/// How long the edges on a body should be, in the unit of the coordinates.
struct OutlineSpacing {
  double elsewhere = 0.01;
  double leading_edge = 0.01 / 3;
  double trailing_edge = 0.01 / 3;  ///< at the trailing edge and every other corner
  double growth = 0.14;             ///< from one edge to the next at most by this fraction, about
  double turn_deg = 5;              ///< from one edge to the next the direction turns by at most this, about
};

/// Points along the outline, counter-clockwise, without repeating the first; every corner is one of them.
///
/// The edge length follows `spacing`: the three lengths asked for, graded between them; shorter where the
/// curve bends (but by the bend alone not under a tenth of the shortest length asked for) and beside pieces
/// shorter than the length asked for, such as a thin blunt trailing edge. Deterministic. Cost O(pieces' knots
/// + points).
[[nodiscard]] std::vector<Point2> distribute(const OutlineCurve&, const OutlineSpacing&);

}  // namespace leonhard::app
