// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"

/// Points made from points, with a proven bound on how far they are from the exact ones.
///
/// A construction rounds, unlike a predicate: nothing may be decided from its result that a predicate can
/// decide from the points. What these functions decide themselves (degenerate or not, obtuse or not, which
/// edge is shortest, near or far) is exact.
///
/// For every finite input, with R the radius and |x| + |y| the sum over the returned centre's coordinates,
///   centre_error <= 2^-50 (R + |x| + |y|) + 2^-1072   and   radius_error <= 2^-49 R + 2^-1072:
/// a few units in the last place, however thin the triangle. Cost: 0.2 us in the plane, 0.8 us in space, in
/// double-double where its bound is good enough, else microseconds in GMP's rationals, which are then
/// rounded.
///
/// Throws InputError, naming the points, where there is no such circle because they are collinear (coplanar,
/// for a sphere), where a coordinate is NaN or infinite, and where the centre or the radius exceeds the largest double.
namespace leonhard::kernel {

/// A circle or sphere; a circle in space has the plane of its triangle.
template <class Point>
struct RoundedBall {
  Point centre;         // where the coordinates are
  double radius;        // in units of the coordinates
  double centre_error;  // upper bound of the distance of centre from the exact centre
  double radius_error;  // upper bound of |radius - exact radius|; the exact one is about the exact centre
};

using Circle = RoundedBall<Point2>;
using Sphere = RoundedBall<Point3>;

/// The circle through three points, in any order. With V = b - a, W = c - a and Q the quarter turn (x, y) ->
/// (-y, x),
///   centre = a + (|W|^2 QV - |V|^2 QW) / (2 V x W).
[[nodiscard]] Circle circumcircle(const Point2& a, const Point2& b, const Point2& c);

/// The circle in space through three points that has its centre in their plane:
///   centre = a + (|V|^2 W - |W|^2 V) x (V x W) / (2 |V x W|^2).
[[nodiscard]] Sphere circumcircle(const Point3& a, const Point3& b, const Point3& c);

/// The sphere through four points, in any order. With T = d - a,
///   centre = a + (|V|^2 W x T + |W|^2 T x V + |T|^2 V x W) / (2 V . W x T).
[[nodiscard]] Sphere circumsphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// The circle that has ab as a diameter; a point if they are equal.
[[nodiscard]] Circle diametral_circle(const Point2& a, const Point2& b);

/// The smallest circle that contains the triangle: the circumcircle if all angles are acute, else the
/// diametral circle of the longest edge. Collinear and equal points are allowed. T. Barth, "Aspects of
/// unstructured grids and finite-volume solvers for the Euler and Navier-Stokes equations", VKI lecture notes
/// (1994), section 3.2.
[[nodiscard]] Circle containment_circle(const Point2& a, const Point2& b, const Point2& c);

/// Which height over the shortest edge, in lengths of that edge, gives the isosceles triangle over it the
/// ratio `radius_edge_ratio` of circumradius to shortest edge.
///
/// radius_edge_ratio  beta >= 1/2, the quality that refinement asks for: 1 / (2 sin of the smallest angle)
/// returns            beta + sqrt(beta^2 - 1/4), rounded
/// throws             InputError if beta < 1/2 or NaN
[[nodiscard]] double off_centre_reach(double radius_edge_ratio);

/// The off-centre of a triangle, where refinement puts a point instead of the circumcentre: on the bisector
/// of the shortest edge, on the triangle's side, at the circumcentre or, if that is farther from the edge, at
/// `reach` edge lengths from it. A. Üngör, "Off-centers: a new type of Steiner points for computing
/// size-optimal quality-guaranteed Delaunay triangulations", LATIN 2004.
///
/// a, b, c  in any order; of equally short edges the first of ab, bc, ca counts
/// reach    positive, as off_centre_reach gives it; infinite (or 2^1023 and more) for the circumcentre itself
/// returns  the off-centre and the circle about it through the ends of the shortest edge; errors against the
///          exact point for this very double `reach`
/// throws   also InputError if reach is not positive
[[nodiscard]] Circle off_centre(const Point2& a, const Point2& b, const Point2& c, double reach);

}  // namespace leonhard::kernel
