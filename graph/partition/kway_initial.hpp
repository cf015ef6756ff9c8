// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/multilevel/kway_random.hpp"
#include "leonhard/graph/partition/kway_bisect.hpp"

namespace leonhard::graph::detail {

/// A partition by bisecting again and again: k parts as floor(k/2) and the rest, the sides' weights in proportion.
///
/// The imbalance that is allowed is shared between the levels of the recursion, so that the parts at its end keep the
/// limit (Schlag and others, ALENEX 2016).
/// limit    of a part's weight, parts * limit at least the graph's weight; may be missed where vertices are heavy
/// returns  to each vertex its part, below `parts`
[[nodiscard]] std::vector<std::uint32_t> recursive_multilevel_bisection(
    const KwayGraph& graph, std::uint32_t parts, std::int64_t limit, const BisectionSettings& settings,
    Random& random, const std::stop_token& stop);

}  // namespace leonhard::graph::detail
