// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

/// Whether a point, if inserted, destroys the triangle with the corners a, b, c, counter-clockwise: it lies
/// inside the circumcircle, ties broken by kernel::incircle_perturbed. a may be the ghost: the circle of a
/// ghost triangle is the open half plane outside its edge, and the open edge itself.
[[nodiscard]] inline bool in_conflict(std::span<const Point2> points, VertexId a, VertexId b, VertexId c,
                                      const Point2& p) {
  const Point2 &to = points[c.index()], &from = points[b.index()];
  if (a != GhostTriangulation::ghost) [[likely]]
    return kernel::incircle_perturbed(points[a.index()], from, to, p) == Sign::positive;
  const Sign turn = kernel::orient2d(from, to, p);
  return turn == Sign::positive ||
         (turn == Sign::zero && (from < to ? from < p && p < to : to < p && p < from));
}

[[nodiscard]] inline bool in_conflict(const GhostTriangulation& in, std::span<const Point2> points,
                                      AnyTriangleId t, const Point2& p) {
  return in_conflict(points, in.corner(t, 0), in.corner(t, 1), in.corner(t, 2), p);
}

}  // namespace leonhard::delaunay
