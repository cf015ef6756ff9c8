// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::mesh {

/// What a renumbering of vertices does to the tetrahedra's numbers.
enum class TetOrder {
  by_smallest_vertex,  ///< sorted by new vertices in ascending order: near vertices, near tetrahedra
  kept,
};

/// The same mesh with other vertex numbers. Markers, regions, boundary, interfaces and names go along; boundary and
/// interfaces keep their order, and each tetrahedron the order of its corners.
///
/// new_of_old  a permutation: the new id of each old vertex
/// throws  InputError if new_of_old is not a permutation of the mesh's vertices, or the mesh has ids out of range or arrays
///         of the wrong size
/// Cost O(vertices + tetrahedra log degree).
[[nodiscard]] TetMesh renumber_vertices(const TetMesh& mesh, const PerId<VertexId, VertexId>& new_of_old,
                                        TetOrder order = TetOrder::by_smallest_vertex);

}  // namespace leonhard::mesh
