// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/mesh/tet_edges.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard {

/// The metrics of a dual of a tetrahedral mesh (Barth's notes 1.2 in space): a control volume about each vertex, a face
/// across each edge. Lengths in the unit of the coordinates.
struct TetDualMetrics {
  /// One per edge: integral of the unit normal over the dual face between ends[0] and ends[1], pointing from ends[0] to
  /// ends[1]. A face bends, so its norm is less than the face's area.
  PerId<EdgeId, Vec3> normal;
  PerId<VertexId, double> volume;  ///< of each control volume
  /// One per entry of mesh.boundary, same order: OUTWARD normal times area of the whole face; a third belongs to each
  /// corner.
  std::vector<Vec3> boundary_normal;
};

namespace mesh {

/// The median dual's metrics: about each vertex the region bounded by the quadrilaterals that join, in each tetrahedron,
/// the midpoint of an edge, the centroids of the two faces at it and the tetrahedron's centroid; on the boundary by its
/// thirds of the boundary faces. A volume is a quarter of the vertex's tetrahedra's.
///
/// edges   of this mesh, from build_edges
/// throws  InputError for edges of another mesh
/// Closed to rounding: about each vertex the outward normals and boundary thirds add up to zero, the volumes add up to
/// the mesh's. All values are made of differences of coordinates, never of centroids' absolute positions, so a mesh far
/// from the origin keeps its digits: the part of edge ab's normal within the positive tetrahedron abcd is half the cross
/// product of the quadrilateral's diagonals, from the edge's midpoint to the tetrahedron's centroid and from one face's
/// centroid to the other's, ((c - a) + (d - b)) x (d - c) / 24.
/// Cost O(tetrahedra log degree).
[[nodiscard]] TetDualMetrics median_dual(const TetMesh& mesh, const TetEdges& edges);

}  // namespace mesh
}  // namespace leonhard
