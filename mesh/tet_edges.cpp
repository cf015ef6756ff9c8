// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_edges.hpp"

#include <algorithm>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/faces.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/structures/half_facets.hpp"

namespace leonhard {

MaybeId<EdgeId> TetEdges::find(VertexId a, VertexId b) const {
  return mesh::find_facet(ends, first_edge, {std::min(a, b), std::max(a, b)});
}

namespace mesh {
namespace {

/// The different pairs among many.
///
/// for_each_pair  calls a function with two vertices for each pair, in either order, the same pairs each time
template <class ForEachPair>
TetEdges edges_of(std::size_t vertices, ForEachPair for_each_pair) {
  // Larger ends in buckets by smaller end.
  std::vector<std::size_t> first(vertices + 1, 0);
  for_each_pair([&](VertexId a, VertexId b) { ++first[std::min(a, b).index() + 1]; });
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<VertexId> highs(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for_each_pair([&](VertexId a, VertexId b) { highs[next[std::min(a, b).index()]++] = std::max(a, b); });

  TetEdges edges;
  edges.ends.reserve(highs.size() / 5);  // some five tetrahedra lie about an edge, and as many faces
  edges.first_edge.reserve(first.size());
  edges.first_edge.push_back(0);
  PerId<VertexId, MaybeId<VertexId>> taken_from(
      vertices);  // the last smaller end that a vertex was joined to
  std::vector<VertexId> group;
  for (std::size_t v = 0; v < vertices; ++v) {
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

}  // namespace

TetEdges build_edges(const TetMesh& mesh) {
  require_corners_in_range(mesh);
  return edges_of(mesh.vertex_count(), [&](auto visit) {
    for (const auto& corners : mesh.corners) {
      for (const auto& [i, j] : tet_edge_corners) visit(corners[i], corners[j]);
    }
  });
}

TetEdges build_edges(const FaceStructure& faces, std::size_t vertices) {
  for (const FaceId f : faces.corners.ids())
    for (const VertexId v : faces.corners[f])
      if (v.index() >= vertices)
        throw InputError("faces",
                         "face " + std::to_string(f.raw) + " names vertex " + std::to_string(v.raw) + " of " +
                             std::to_string(vertices),
                         "give the number of the mesh's vertices");
  return edges_of(vertices, [&](auto visit) {
    for (const auto& [a, b, c] : faces.corners) visit(a, b), visit(a, c), visit(b, c);
  });
}

}  // namespace mesh
}  // namespace leonhard
