// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// A closed walk along the boundary of a triangle mesh that visits no vertex twice. The mesh lies to its left: an outer
/// loop runs counter-clockwise, one about a hole clockwise.
struct BoundaryLoop {
  std::vector<VertexId> vertices;  ///< the smallest first; the last is joined to the first
  std::vector<Marker> markers;     ///< of the edges: markers[i] from vertices[i] to the next
  std::size_t
      component{};  ///< of the triangles that hang together by edges, in the order of their smallest ids
  bool is_outer{};  ///< the area that it encloses is positive, by an exact sum; else it is about a hole
};

/// The boundary of a triangle mesh as closed loops, sorted by component, the outer loop before the holes, these by
/// smallest vertex.
///
/// Where parts of the boundary touch in a vertex each loop goes on so that loops touch but do not cross, and is cut where
/// it comes back: parts of the mesh that touch have loops of their own, and so have holes that touch each other or the
/// outer boundary. So each component has one outer loop, if the mesh lies properly in the plane (`validate_embedding`).
/// The loops depend on the triangles alone, not on the order of mesh.boundary.
///
/// mesh    passes `validate`
/// throws  InputError if mesh.boundary is not the boundary that mesh.neighbours has
/// Cost O(triangles + boundary log boundary).
[[nodiscard]] std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh);

/// A connected part of the boundary of a tetrahedral mesh.
struct BoundarySurface {
  std::vector<std::size_t> faces;  ///< indices into mesh.boundary, ascending
  std::size_t
      component{};  ///< of the tetrahedra that hang together by faces, in the order of their smallest ids
  bool is_outer{};  ///< the volume that it encloses is positive, by an exact sum; else it is that of a cavity
};

/// The boundary of a tetrahedral mesh as closed surfaces, sorted by component, the outer one before the cavities, these
/// by smallest face.
///
/// Two faces are joined at an edge if the tetrahedra between them turn about it. So parts of the mesh that touch along an
/// edge or in a vertex have surfaces of their own, cavities that touch in a vertex too, while cavities that touch along an
/// edge are one surface, as if the edge were opened between them (as in the Euler account).
///
/// mesh    passes `validate`
/// throws  InputError if mesh.boundary is not the boundary that mesh.neighbours has
/// Cost O(tetrahedra + boundary log boundary), if few boundary faces meet in an edge.
[[nodiscard]] std::vector<BoundarySurface> boundary_surfaces(const TetMesh& mesh);

}  // namespace leonhard::mesh
