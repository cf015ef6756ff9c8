// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/delaunay/plane/triangle_bounds.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// Where to put a vertex that removes a triangle: on the ray from the middle of its shortest edge to its
/// circumcentre, at the circumcentre or, if that is farther, at `reach` edge lengths from the edge.
///
/// reach    positive; infinite for the circumcentre itself
/// returns  may be not finite for triangles that are flat to rounding
/// Method: the off-centre of Üngör, LATIN 2004.
[[nodiscard]] Point2 off_centre(const CornerPoints& t, const Shape& shape, double reach);

/// The reach with which the new triangle on the shortest edge just meets the bound: (1/2) cot(angle / 2), less
/// 5 percent so that rounding does not leave it below.
[[nodiscard]] double off_centre_reach(double min_angle_deg);

/// The middle of ab, the same point for ba. Does not overflow.
[[nodiscard]] Point2 middle(Point2 a, Point2 b);

/// The point of the segment from `apex` to `end` on the shell (circle about apex) whose radius is the power of two
/// between 1/3 and 2/3 of the length, missed by the relative `tolerance` at most: of all fractions j/2^m of the
/// way that come close enough the one of smallest m, so that on a dyadic grid of coordinates the point is on the
/// segment without rounding.
/// Ruppert 1995, section 6: segments that meet in the apex get equal lengths and do not encroach on each other.
[[nodiscard]] Point2 shell_point(Point2 apex, Point2 end, double tolerance);

}  // namespace leonhard::delaunay
