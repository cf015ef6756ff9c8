// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "leonhard/mesh/permute.hpp"

/// An order of a mesh's vertices applied to the mesh.
namespace leonhard::graph {

/// A mesh in another numbering, and where everything went.
template <int Dim>
struct Reordered : mesh::Renumbered<Dim> {
  PerId<VertexId, VertexId> new_vertex;  ///< of each old vertex
};

/// The mesh with its vertices in a given order (mesh::renumber).
///
///   const auto ordered = graph::reorder(mesh, graph::order(graph::vertex_graph(mesh, edges)).order);
///   const auto field = graph::carried(old_field, ordered.new_vertex);
///
/// mesh    of triangles or tetrahedra
/// order   order[new] = old, as graph::order() gives it for the mesh's vertex graph
/// cells   sorted by their vertices, so that near vertices have near cells, or as they were
/// throws  InputError if order is no permutation of the mesh's vertices
/// Cost O(vertices + cells log degree).
template <int Dim>
[[nodiscard]] Reordered<Dim> reorder(const SimplexMesh<Dim>& mesh, std::span<const std::uint32_t> order,
                                     mesh::CellOrder cells = mesh::CellOrder::by_smallest_vertex);

/// Values of vertices or cells in the new numbering.
///
/// values      one an old id
/// new_of_old  a permutation, such as Reordered::new_cell
template <class IdT, class T>
[[nodiscard]] PerId<IdT, T> carried(const PerId<IdT, T>& values, const PerId<IdT, IdT>& new_of_old) {
  PerId<IdT, T> result(values.size());
  for (const IdT old : values.ids()) result[new_of_old[old]] = values[old];
  return result;
}

}  // namespace leonhard::graph
