// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "leonhard/graph/multilevel/kway_graph.hpp"

namespace leonhard::graph::detail {

/// Brings every part into one piece.
///
/// Loose pieces go to the part beside with most edges to them; what is too heavy then hands vertices on along the
/// shortest way through the parts to one with room, each time a vertex that its part does not need to hold together.
/// limit    of a part's weight; kept
/// part_of  every part keeps the limit; changed only if all parts become connected within it
/// returns  whether every part is connected
/// Cost O(n + m) for the pieces, and the size of a part for each vertex handed on.
[[nodiscard]] bool connect_parts(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
                                 std::vector<std::uint32_t>& part_of, const std::stop_token& stop);

}  // namespace leonhard::graph::detail
