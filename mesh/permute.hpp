// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// What a renumbering of vertices does to the triangles' numbers.
enum class TriangleOrder {
  by_smallest_vertex,  ///< sorted by smallest new vertex, then middle, then largest: near vertices, near
                       ///< triangles
  kept,
};

/// The same mesh with other vertex numbers. Markers, regions, boundary, constraints and names go along;
/// boundary and constraints keep their order, and each triangle the corner that it starts with.
///
/// new_of_old  a permutation: the new id of each old vertex
/// throws  InputError if new_of_old is not a permutation of the mesh's vertices, or the mesh has ids out of range or arrays
///         of the wrong size
/// Cost O(vertices + triangles log degree).
[[nodiscard]] TriangleMesh renumber_vertices(const TriangleMesh& mesh,
                                             const PerId<VertexId, VertexId>& new_of_old,
                                             TriangleOrder order = TriangleOrder::by_smallest_vertex);

}  // namespace leonhard::mesh
