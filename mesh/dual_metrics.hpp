// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/mesh/edges.hpp"

namespace leonhard {

/// The metrics of a dual of a triangle mesh (Barth's notes 1.2, figure 1.2.0): a control volume about each vertex, a
/// face across each edge. Lengths in the unit of the coordinates.
struct DualMetrics {
  /// One per edge: integral of the unit normal over the dual face between ends[0] and ends[1], pointing from
  /// ends[0] to ends[1]. A face may bend, so its norm is the distance between the face's ends.
  PerId<EdgeId, Vec2> normal;
  PerId<VertexId, double> area;  ///< of each control volume
  /// One per entry of mesh.boundary, same order: OUTWARD normal times length of the whole edge; half belongs
  /// to each end.
  std::vector<Vec2> boundary_normal;
};

namespace mesh {

/// The dual whose faces are straight: across an interior edge from the centre of its right triangle to that of its left
/// one, across a boundary edge from its midpoint to the centre of its triangle. What the centroid and the Dirichlet
/// dual share.
///
/// edges    of this mesh, from build_edges
/// centres  one a triangle, anywhere: about each vertex the normals add up to zero, and the areas, negative parts
///          counted so, add up to the mesh's
/// throws   InputError for edges of another mesh, and unless there is one centre a triangle
/// Cost O(edges).
[[nodiscard]] DualMetrics straight_dual(const TriangleMesh& mesh, const EdgeStructure& edges,
                                        const PerId<TriangleId, Point2>& centres);

}  // namespace mesh
}  // namespace leonhard
