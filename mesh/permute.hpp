// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// What a renumbering of vertices does to the cells' numbers.
enum class CellOrder {
  by_smallest_vertex,  ///< sorted by new vertices in ascending order: near vertices, near cells
  kept,
};

/// A mesh in another numbering, and where its cells went.
template <int Dim>
struct Renumbered {
  using CellId = typename SimplexMesh<Dim>::CellId;

  SimplexMesh<Dim> mesh;
  PerId<CellId, CellId> new_cell;  ///< of each old cell
};

/// The same mesh with other vertex numbers. Markers, regions, boundary, inner facets and names go along; boundary and
/// inner facets keep their order, and each cell the order of its corners.
///
/// new_of_old  a permutation: the new id of each old vertex
/// throws  InputError if new_of_old is not a permutation of the mesh's vertices, or the mesh has ids out of range or arrays
///         of the wrong size
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] Renumbered<Dim> renumber(const SimplexMesh<Dim>& mesh,
                                       const PerId<VertexId, VertexId>& new_of_old,
                                       CellOrder order = CellOrder::by_smallest_vertex);

/// The mesh of renumber() alone.
template <int Dim>
[[nodiscard]] SimplexMesh<Dim> renumber_vertices(const SimplexMesh<Dim>& mesh,
                                                 const PerId<VertexId, VertexId>& new_of_old,
                                                 CellOrder order = CellOrder::by_smallest_vertex);

/// A mesh of mixed cells in another numbering, and where its cells went.
template <int Dim>
struct RenumberedMixed {
  MixedMesh<Dim> mesh;
  PerId<CellId, CellId> new_cell;  ///< of each old cell
};

/// renumber() of mixed cells: these are sorted by new vertices in ascending order.
template <int Dim>
[[nodiscard]] RenumberedMixed<Dim> renumber(const MixedMesh<Dim>& mesh,
                                            const PerId<VertexId, VertexId>& new_of_old);

/// The same dual with other vertex numbers: edges are sorted anew, and a face vector whose edge's ends change places is
/// turned; boundary facets keep their order, and each the order of its corners. No value changes but for such signs.
///
/// throws  InputError if new_of_old is not a permutation of the dual's vertices
/// Cost O(vertices + edges log degree).
template <int Dim>
[[nodiscard]] MeshDual<Dim> renumber_vertices(const MeshDual<Dim>& dual,
                                              const PerId<VertexId, VertexId>& new_of_old);

}  // namespace leonhard::mesh
