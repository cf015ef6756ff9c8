// SPDX-License-Identifier: MIT
#include "leonhard/mesh/edges.hpp"

#include <optional>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/structures/half_edges.hpp"
#include "leonhard/mesh/structures/sorted_ends.hpp"

namespace leonhard {

MaybeId<EdgeId> EdgeStructure::find(VertexId a, VertexId b) const {
  return mesh::find_edge(ends, first_edge, a, b);
}

namespace mesh {
namespace {

void refuse(const std::optional<std::string>& problem) {
  if (problem) throw InputError("", *problem, "correct the list of triangles");
}

}  // namespace

EdgeStructure build_edges(const TriangleMesh& mesh) {
  refuse(broken_corner(mesh));
  const HalfEdgeTable table = half_edge_table(mesh);
  refuse(broken_edge(mesh, table));

  EdgeStructure edges;
  const std::size_t expected = table.entries.size() / 2 + mesh.boundary.size() / 2 + 1;
  edges.ends.reserve(expected);
  edges.sides.reserve(expected);
  edges.first_edge.reserve(table.first.size());
  edges.first_edge.push_back(0);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (std::size_t i = table.first[v]; i < table.first[v + 1]; ++i) {
      const HalfEdge& half = table.entries[i];
      if (i == table.first[v] || table.entries[i - 1].high != half.high) {
        edges.ends.push_back({VertexId::from(v), half.high});
        edges.sides.push_back({});
      }
      edges.sides.flat().back()[half.forward ? 0 : 1] = half.triangle;
    }
    edges.first_edge.push_back(static_cast<IdRaw>(edges.ends.size()));
  }
  return edges;
}

}  // namespace mesh
}  // namespace leonhard
