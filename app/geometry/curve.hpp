// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::app {

/// One smooth stretch of an outline between two corners.
struct CurvePiece {
  std::function<Point2(double)> at;  ///< the point at parameter t in [knots.front(), knots.back()]
  std::vector<double> knots;         ///< rising; between two knots the curve has no detail of its own
};

/// The outline of a body: smooth pieces, end to end, counter-clockwise, the last ending where the first
/// begins. A corner lies between two pieces; a single piece may close on itself smoothly.
struct OutlineCurve {
  std::vector<CurvePiece> pieces;
  bool smooth_start = false;  ///< no corner where the last piece meets the first
  Point2 leading_edge;        ///< a point of the curve
  Point2 trailing_edge;       ///< middle of a blunt one
};

/// The smooth curve through points given in order around a body (the order of AirfoilCoordinates: counter-
/// clockwise from the upper trailing edge, closed without repeating the first point).
///
/// A point where the polygon turns by more than corner_angle_deg is a corner and stays one: pieces between
/// corners are separate cubic splines over chord length (second derivative constant in the end intervals,
/// periodic if there is no corner at all). Without an angle given it is 40 degrees, but 120 at the leading edge
/// (the point farthest from the trailing edge): coarse files turn by more than 40 degrees there although the
/// nose is round. The blunt trailing edge, from the last point to the first, is a straight piece of its own.
///
/// points  at least 4, no two neighbours equal (see check_outline)
/// Cost O(points).
[[nodiscard]] OutlineCurve spline_outline(const std::vector<Point2>& points, bool blunt_trailing_edge,
                                          std::optional<double> corner_angle_deg);

/// The largest distance between two of the points, from the trailing edge: the chord.
[[nodiscard]] double chord_length(const OutlineCurve&);

/// Scale, then rotate counter-clockwise about the origin, then translate.
struct Placement {
  double scale = 1;
  double rotation_deg = 0;
  Vec2 translation;
  [[nodiscard]] Point2 operator()(Point2) const;
};

[[nodiscard]] OutlineCurve place(const OutlineCurve&, const Placement&);

}  // namespace leonhard::app
