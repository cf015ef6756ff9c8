// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard {

/// The out-degree structure of Barth's notes 1.3 (figure 1.3.0 c): the graph's edges directed, each listed
/// once, at its tail. On a planar mesh every list can be short: at most five with smallest_last_tails, three
/// at best.
struct OutDegreeList {
  std::vector<IdRaw> first;     ///< heads of v are heads[first[v]] .. heads[first[v + 1] - 1]
  std::vector<VertexId> heads;  ///< ascending within each list

  [[nodiscard]] std::size_t vertex_count() const { return first.empty() ? 0 : first.size() - 1; }
  [[nodiscard]] std::size_t edge_count() const { return heads.size(); }
  /// The vertices that edges listed at v lead to. v is below vertex_count(): a precondition, not checked, here and of the
  /// two that follow.
  [[nodiscard]] std::span<const VertexId> heads_of(VertexId v) const {
    return std::span(heads).subspan(first[v.index()], out_degree(v));
  }
  [[nodiscard]] std::size_t out_degree(VertexId v) const { return first[v.index() + 1] - first[v.index()]; }
  /// Is there an edge between two vertices, in either direction? Cost O(log out-degree).
  [[nodiscard]] bool has_edge(VertexId a, VertexId b) const {
    const auto listed = [this](VertexId tail, VertexId head) {
      const auto list = heads_of(tail);
      return std::binary_search(list.begin(), list.end(), head);
    };
    return listed(a, b) || listed(b, a);
  }
};

namespace mesh {

/// Tails by which no vertex of a planar graph has more than five outgoing edges: vertices are removed one
/// after another, always one of least degree, and each edge is directed away from the end that goes first.
/// For other graphs the bound is the degeneracy.
///
/// returns  one an edge: the end at which it is to be listed
/// Cost O(vertices + edges).
/// Method: smallest-last order, Matula and Beck, Journal of the ACM 30 (1983); a planar graph always has a
/// vertex of degree five or less.
[[nodiscard]] PerId<EdgeId, VertexId> smallest_last_tails(const EdgeStructure& edges);

/// The out-degree list for given directions.
///
/// tails   one an edge: one of its ends
/// throws  InputError if there is not one tail an edge, or one is no end of its edge
/// Cost O(vertices + edges).
[[nodiscard]] OutDegreeList out_degree_list(const EdgeStructure& edges, const PerId<EdgeId, VertexId>& tails);

/// The out-degree list with smallest_last_tails.
[[nodiscard]] OutDegreeList out_degree_list(const EdgeStructure& edges);

}  // namespace mesh
}  // namespace leonhard
