// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "leonhard/delaunay/point_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_arena.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay tetrahedralisation by incremental insertion in rounds of random points, each along the curve: algorithm
/// "insertion", the default.
///
/// With several threads each takes a piece of the curve and inserts those of its points whose cavities stay among its own
/// vertices; those near the seams between pieces come afterwards, with the seams elsewhere, and at last one by one. The
/// set of tetrahedra is the same, their numbers are not.
///
/// points  distinct, finite, along a space-filling curve
/// Cost O(n) expected for points that fill space. 32 bytes a point and 33 a tetrahedron.
PointTetrahedralization tetrahedralize_insertion(std::span<const Point3> points,
                                                 const TetAlgorithmOptions& options);

/// What insert_nodes made; empty unless done.
struct [[nodiscard]] InsertedNodes {
  TetrahedralizeOutcome outcome = TetrahedralizeOutcome::done;
  GhostTetrahedralization cells;
  std::vector<TetId> dead;  ///< numbers in cells that no tetrahedron has
};

/// The same for points already in their nodes, which are freed afterwards.
InsertedNodes insert_nodes(std::vector<TetNode> nodes, const TetAlgorithmOptions& options);

}  // namespace leonhard::delaunay
