// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "leonhard/graph/multilevel/bisection_goal.hpp"
#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/multilevel/kway_random.hpp"
#include "leonhard/graph/multilevel/kway_settings.hpp"

namespace leonhard::graph::detail {

/// To each vertex its side, 0 or 1.
///
/// Within the limits wherever moves of single vertices lead there. A graph without edges, or of many components, is
/// dealt with like any other.
/// Method: multilevel; sides grown from a random vertex by largest gain (Karypis and Kumar 1998), refined by TwoWayFm
/// and KwayFlow.
[[nodiscard]] std::vector<std::uint32_t> multilevel_bisection(const KwayGraph& graph,
                                                              const BisectionGoal& goal,
                                                              const BisectionSettings& settings,
                                                              Random& random, const std::stop_token& stop);

}  // namespace leonhard::graph::detail
