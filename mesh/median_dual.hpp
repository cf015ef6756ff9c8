// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// Control volumes of the median dual (Barth's notes 1.2, figure 1.2.0): about each vertex the region bounded
/// by the lines from the midpoints of its edges to the centroids of its triangles, and on the boundary by its
/// halves of the boundary edges. Lengths in the unit of the coordinates.
struct MedianDual {
  /// One per edge: integral of the unit normal over the dual face between ends[0] and ends[1], pointing from
  /// ends[0] to ends[1]. The face may bend at the midpoint, so its norm is the distance between the face's
  /// ends.
  PerId<EdgeId, Vec2> normal;
  PerId<VertexId, double> area;  ///< of each control volume: a third of its triangles' areas
  /// One per entry of mesh.boundary, same order: OUTWARD normal times length of the whole edge; half belongs
  /// to each end.
  std::vector<Vec2> boundary_normal;
};

namespace mesh {

/// The median dual's metrics.
///
/// edges   of this mesh, from build_edges
/// Closed to rounding: about each vertex the outward normals and boundary halves add up to zero, the areas
/// add up to the mesh's. All values are made of differences of coordinates, never of centroids' absolute
/// positions, so a mesh far from the origin keeps its digits: an interior normal is (o_left - o_right)/3
/// turned clockwise by a right angle, o being the corners opposite the edge. Cost O(edges + triangles).
[[nodiscard]] MedianDual median_dual(const TriangleMesh& mesh, const EdgeStructure& edges);

}  // namespace mesh
}  // namespace leonhard
