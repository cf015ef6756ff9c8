// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_edges.hpp"

#include <algorithm>

#include "leonhard/mesh/sorted_ends.hpp"

namespace leonhard {

MaybeId<EdgeId> TetEdges::find(VertexId a, VertexId b) const {
  return mesh::find_edge(ends, first_edge, a, b);
}

namespace mesh {
namespace {

/// Calls visit(smaller, larger end) for the six edges of every tetrahedron.
template <class Visit>
void for_each_side(const TetMesh& mesh, Visit visit) {
  for (const auto& corners : mesh.corners) {
    for (const auto& [i, j] : tet_edge_corners)
      visit(std::min(corners[i], corners[j]), std::max(corners[i], corners[j]));
  }
}

}  // namespace

TetEdges build_edges(const TetMesh& mesh) {
  // Larger ends in buckets by smaller end, one a tetrahedron about the edge.
  std::vector<std::size_t> first(mesh.vertex_count() + 1, 0);
  for_each_side(mesh, [&](VertexId low, VertexId) { ++first[low.index() + 1]; });
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<VertexId> highs(6 * mesh.tet_count());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for_each_side(mesh, [&](VertexId low, VertexId high) { highs[next[low.index()]++] = high; });

  TetEdges edges;
  edges.ends.reserve(highs.size() / 5);  // some five tetrahedra lie about an edge
  edges.first_edge.reserve(first.size());
  edges.first_edge.push_back(0);
  PerId<VertexId, MaybeId<VertexId>> taken_from(
      mesh.vertex_count());  // the last smaller end it was joined to
  std::vector<VertexId> group;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const VertexId low = VertexId::from(v);
    group.clear();
    for (std::size_t i = first[v]; i < first[v + 1]; ++i) {
      if (taken_from[highs[i]] == MaybeId<VertexId>(low)) continue;
      taken_from[highs[i]] = low;
      group.push_back(highs[i]);
    }
    std::sort(group.begin(), group.end());
    for (const VertexId high : group) edges.ends.push_back({low, high});
    edges.first_edge.push_back(static_cast<IdRaw>(edges.ends.size()));
  }
  return edges;
}

}  // namespace mesh
}  // namespace leonhard
