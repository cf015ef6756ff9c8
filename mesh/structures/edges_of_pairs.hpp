// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "leonhard/mesh/edge_list.hpp"

namespace leonhard::mesh {

/// The different pairs among many.
///
/// for_each_pair  calls a function with two vertices for each pair, in either order, the same pairs each time
/// Cost O(vertices + pairs), one sort by buckets.
template <class ForEachPair>
[[nodiscard]] EdgeList edges_of(std::size_t vertices, ForEachPair for_each_pair) {
  // Larger ends in buckets by smaller end.
  std::vector<std::size_t> first(vertices + 1, 0);
  for_each_pair([&](VertexId a, VertexId b) { ++first[std::min(a, b).index() + 1]; });
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<VertexId> highs(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for_each_pair([&](VertexId a, VertexId b) { highs[next[std::min(a, b).index()]++] = std::max(a, b); });

  EdgeList edges;
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

}  // namespace leonhard::mesh
