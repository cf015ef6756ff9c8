// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_corners.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/predicates3.hpp"

/// Where points lie with respect to the tetrahedra of a GhostTetrahedralization whose real tetrahedra are positive.
namespace leonhard::delaunay {

/// On which side of the face opposite corner i of t does p lie? The face must be real: of a ghost tetrahedron only the
/// one opposite corner 0 is.
///
/// returns  positive on the side of t (for a ghost: beyond the hull), zero in the plane of the face
[[nodiscard]] inline Sign side_of_face(const GhostTetrahedralization& in, std::span<const Point3> points,
                                       TetId t, unsigned i, const Point3& p) {
  const TetCorners& c = in.corners[t];
  const auto at = [&](unsigned k) -> const Point3& { return k == i ? p : points[c[k].index()]; };
  return kernel::orient3d(at(0), at(1), at(2), at(3));
}

/// Whether p, if inserted, destroys t: it lies inside the circumsphere, ties broken by kernel::insphere_perturbed. The
/// sphere of a ghost tetrahedron is the open half space beyond its face and, in the plane of the face, what the real
/// tetrahedron behind it has inside its own; which is the circumcircle of the face, ties broken the same way whatever
/// lies behind.
[[nodiscard]] inline bool in_conflict(const GhostTetrahedralization& in, std::span<const Point3> points,
                                      TetId t, const Point3& p) {
  if (in.is_ghost(t)) {
    const Sign side = side_of_face(in, points, t, 0, p);
    if (side != Sign::zero) return side == Sign::positive;
    t = *in.neighbours[t][0];
  }
  const TetCorners& c = in.corners[t];
  return kernel::insphere_perturbed(points[c[0].index()], points[c[1].index()], points[c[2].index()],
                                    points[c[3].index()], p) == Sign::positive;
}

/// Take up to `steps` steps of a visibility walk towards p: over a face that has p strictly behind it.
///
/// t        where it began, and where it arrived: real, or a ghost with p strictly beyond its face
/// returns  whether t is the answer of walk
inline bool walk_some(const GhostTetrahedralization& in, std::span<const Point3> points, TetId& t,
                      const Point3& p, std::size_t steps) {
  if (in.is_ghost(t)) t = *in.neighbours[t][0];
  unsigned entered = 4;  // p is known to be on the inner side of this face
  while (true) {
    unsigned i = 0;
    while (i < 4 && (i == entered || side_of_face(in, points, t, i, p) != Sign::negative)) ++i;
    if (i == 4) return true;
    if (steps-- == 0) return false;
    entered = mirror_index(in, t, i);
    t = *in.neighbours[t][i];
    if (in.is_ghost(t)) return true;
  }
}

/// The tetrahedron that holds p; or a ghost with p strictly beyond its face. No walk comes back to a tetrahedron in a
/// Delaunay tetrahedralisation, ties broken by any lifting (Edelsbrunner 1990), so it ends.
[[nodiscard]] inline TetId walk(const GhostTetrahedralization& in, std::span<const Point3> points, TetId from,
                                const Point3& p) {
  walk_some(in, points, from, p, std::numeric_limits<std::size_t>::max());
  return from;
}

}  // namespace leonhard::delaunay
