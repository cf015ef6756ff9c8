// SPDX-License-Identifier: MIT
#include "leonhard/graph/reorder.hpp"

#include <string>
#include <utility>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {

template <int Dim>
Reordered<Dim> reorder(const SimplexMesh<Dim>& mesh, std::span<const std::uint32_t> order,
                       mesh::CellOrder cells) {
  if (order.size() != mesh.vertex_count())
    throw InputError(
        "order",
        std::to_string(order.size()) + " numbers for " + std::to_string(mesh.vertex_count()) + " vertices",
        "give each vertex of the mesh once");
  PerId<VertexId, VertexId> new_vertex;
  new_vertex.reserve(order.size());
  for (const std::uint32_t place : invert(order)) new_vertex.push_back(VertexId::from(place));
  mesh::Renumbered<Dim> renumbered = mesh::renumber(mesh, new_vertex, cells);
  return {std::move(renumbered), std::move(new_vertex)};
}

template Reordered<2> reorder(const SimplexMesh<2>&, std::span<const std::uint32_t>, mesh::CellOrder);
template Reordered<3> reorder(const SimplexMesh<3>&, std::span<const std::uint32_t>, mesh::CellOrder);

}  // namespace leonhard::graph
