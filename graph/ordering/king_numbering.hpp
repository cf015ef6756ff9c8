// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/support/step_counter.hpp"

namespace leonhard::graph::detail {

/// King's numbering of a connected graph: always the vertex of the front that brings the fewest others to the front,
/// and among those the one that came to it first. Not for callers outside this room.
///
/// level_of  levels to be numbered one after another, the root on level 0, each next to those before; empty: one level
/// steps     one a vertex; if it was stopped the order ends early
/// Cost O(m log n).
[[nodiscard]] std::vector<std::uint32_t> king_numbering(const CsrGraph& graph, std::uint32_t root,
                                                        std::span<const std::uint32_t> level_of,
                                                        StepCounter& steps);

}  // namespace leonhard::graph::detail
