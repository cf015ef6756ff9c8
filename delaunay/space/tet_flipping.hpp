// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/delaunay/point_tetrahedralization.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay tetrahedralisation of distinct, finite points by local transformations: each point splits what holds
/// it, then faces opposite to it are flipped until all are Delaunay.
///
/// A point splits a tetrahedron (a ghost too) into 4, two with a common face into 6, the n about an edge into 2n. A flip
/// replaces 2 tetrahedra by 3, 3 by 2, or, about an edge crossed by a segment in a plane, 4 by 4; on the hull ghosts take
/// part in all of these. Points in degenerate position are not moved: only the lifting is perturbed
/// (kernel::insphere_perturbed), no tetrahedron is ever flat.
///
/// Cost expected O(n log n) for points that fill space, some 20 to 30 microseconds a point: the second opinion that the fast
/// algorithm is tested against, not its rival.
/// Method: B. Joe, "Construction of three-dimensional Delaunay triangulations using local transformations", CAGD 8
/// (1991); H. Edelsbrunner and N. R. Shah, "Incremental topological flipping works for regular triangulations",
/// Algorithmica 15 (1996).
PointTetrahedralization tetrahedralize_flipping(std::span<const Point3> points,
                                                const TetAlgorithmOptions& options);

}  // namespace leonhard::delaunay
