// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/support/step_counter.hpp"

/// Boost.Graph's own colourings, for those who compare; not for callers outside this room.
namespace leonhard::graph::detail {

/// sequential_vertex_coloring, by index.
///
/// colour_of  becomes one a vertex
/// returns    the number of colours
[[nodiscard]] std::uint32_t boost_colour_vertices(const CsrGraph& graph,
                                                  std::vector<std::uint32_t>& colour_of);

/// edge_coloring, after Misra and Gries: as many colours as the largest degree, or one more.
///
/// colour_of  becomes one an edge in the sequence of edges_of()
/// steps      two an edge
/// returns    the number of colours; none where it was stopped
[[nodiscard]] std::optional<std::uint32_t> boost_colour_edges(const CsrGraph& graph,
                                                              std::vector<std::uint32_t>& colour_of,
                                                              StepCounter& steps);

}  // namespace leonhard::graph::detail
