// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard {

/// The metrics of a dual of a mesh of triangles (Barth's notes 1.2, figure 1.2.0) or tetrahedra: a control volume about
/// each vertex, a face across each edge. Lengths in the unit of the coordinates; volumes and normals are areas and lengths
/// in the plane.
template <int Dim>
struct DualMetrics {
  using Vector = typename Simplex<Dim>::Vector;
  /// One per edge: integral of the unit normal over the dual face between ends[0] and ends[1], pointing from
  /// ends[0] to ends[1]. A face may bend, so its norm is that of the straight face with the same border, less than the
  /// face's own area or length.
  PerId<EdgeId, Vector> normal;
  PerId<VertexId, double> volume;  ///< of each control volume
  /// One per entry of mesh.boundary, same order: OUTWARD normal times length or area of the whole facet; 1/Dim of it
  /// belongs to each corner.
  std::vector<Vector> boundary_normal;
};

namespace mesh {

/// DualMetrics::boundary_normal of any dual. Cost O(boundary).
[[nodiscard]] std::vector<Vec2> boundary_normals(const TriangleMesh& mesh);
[[nodiscard]] std::vector<Vec3> boundary_normals(const TetMesh& mesh);

/// The dual whose faces are straight: across an interior edge from the centre of its right triangle to that of its left
/// one, across a boundary edge from its midpoint to the centre of its triangle. What the centroid and the Dirichlet
/// dual share.
///
/// edges    of this mesh, from build_edges
/// centres  one a triangle, anywhere: about each vertex the normals add up to zero, and the areas, negative parts
///          counted so, add up to the mesh's
/// throws   InputError for edges of another mesh, and unless there is one centre a triangle
/// Cost O(edges).
[[nodiscard]] DualMetrics<2> straight_dual(const TriangleMesh& mesh, const EdgeStructure& edges,
                                           const PerId<TriangleId, Point2>& centres);

}  // namespace mesh
}  // namespace leonhard
