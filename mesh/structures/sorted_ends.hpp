// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "leonhard/mesh/id.hpp"

namespace leonhard::mesh {

/// The edge between two vertices, given in either order; none if there is no such edge. Cost O(log degree).
///
/// ends        of each edge, ascending, edges sorted by them
/// first_edge  edges with ends[0] == v are first_edge[v] .. first_edge[v + 1] - 1
[[nodiscard]] inline MaybeId<EdgeId> find_edge(const PerId<EdgeId, std::array<VertexId, 2>>& ends,
                                               const std::vector<IdRaw>& first_edge, VertexId a, VertexId b) {
  if (a > b) std::swap(a, b);
  if (a.index() + 1 >= first_edge.size()) return {};
  const auto begin = ends.begin() + static_cast<std::ptrdiff_t>(first_edge[a.index()]);
  const auto end = ends.begin() + static_cast<std::ptrdiff_t>(first_edge[a.index() + 1]);
  const auto at = std::partition_point(begin, end, [&](const auto& edge) { return edge[1] < b; });
  if (at == end || (*at)[1] != b) return {};
  return EdgeId::from(static_cast<std::size_t>(at - ends.begin()));
}

}  // namespace leonhard::mesh
