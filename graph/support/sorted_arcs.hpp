// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"

/// How this room makes its graphs; not for callers outside it.
namespace leonhard::graph::detail {

/// Directed edges, source and target.
using Arcs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// arcs  ascending by source, then target; both directions of every edge
[[nodiscard]] inline CsrGraph graph_of_sorted_arcs(const Arcs& arcs, std::size_t vertices) {
  return CsrGraph(boost::edges_are_sorted, arcs.begin(), arcs.end(), static_cast<std::uint32_t>(vertices),
                  static_cast<std::uint32_t>(arcs.size()));
}

}  // namespace leonhard::graph::detail
