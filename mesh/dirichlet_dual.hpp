// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "leonhard/mesh/dual_metrics.hpp"

namespace leonhard {

/// The Dirichlet dual's metrics, and where it is not the Dirichlet tessellation itself.
struct DirichletDual : DualMetrics<2> {
  /// Entries of mesh.boundary whose triangle has its circumcentre strictly beyond the edge, because the angle opposite
  /// is obtuse; decided exactly.
  std::vector<std::size_t> beyond;
};

namespace mesh {

/// The Dirichlet dual (Barth's notes 1.2): segments between the circumcentres of neighbouring triangles, perpendicular
/// to the edges, and from a boundary edge's midpoint to its triangle's circumcentre.
///
/// Where no circumcentre lies beyond the boundary (`beyond` is empty: the diametral circles of the boundary edges hold
/// no vertex), the control volumes are the vertices' Voronoi cells within the domain. Elsewhere nothing is clipped: the
/// face across that boundary edge counts negative, so that the control volume of the opposite vertex keeps what reaches
/// beyond the edge and those of the edge's ends lose as much. Closedness, total area and the boundary edges' halves stay
/// right; single areas near there are not those of clipped cells, and may be negative.
///
/// mesh   Delaunay (validate_delaunay): faces across its interior edges are then never negative
/// edges  of this mesh, from build_edges
/// throws InputError for edges of another mesh, a boundary that is not the mesh's, and where a circumcentre lies beyond the largest double
/// Cost O(edges + triangles), a quarter of a microsecond a triangle.
[[nodiscard]] DirichletDual dirichlet_dual(const TriangleMesh& mesh, const EdgeStructure& edges);

}  // namespace mesh
}  // namespace leonhard
