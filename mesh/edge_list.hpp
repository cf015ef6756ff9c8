// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "leonhard/mesh/id.hpp"

namespace leonhard {

/// The edges of a mesh, sorted by (ends[0], ends[1]), so that their numbers depend on the vertices' numbers alone.
struct EdgeList {
  PerId<EdgeId, std::array<VertexId, 2>> ends;  ///< ends[e][0] < ends[e][1]
  std::vector<IdRaw> first_edge;  ///< edges with ends[0] == v are first_edge[v] .. first_edge[v + 1] - 1

  [[nodiscard]] std::size_t edge_count() const { return ends.size(); }

  /// The edge between two vertices, given in either order; none if there is no such edge. Cost O(log degree).
  [[nodiscard]] MaybeId<EdgeId> find(VertexId a, VertexId b) const;

  friend bool operator==(const EdgeList&, const EdgeList&) = default;
};

}  // namespace leonhard
