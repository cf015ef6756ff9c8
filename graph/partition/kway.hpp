// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/multilevel/kway_settings.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::graph::detail {

struct KwayResult {
  std::vector<std::uint32_t> part_of;
  bool stopped{};
};

/// The multilevel k-way partitioner behind partition().
///
/// With a population of several, the best two of three are combined again and again (Sanders and Schulz, ALENEX 2012):
/// what neither cuts stays joined on the way down, the better one is where the way up starts, and the outcome takes
/// the place of the worst.
/// limit  of a part's weight; parts * limit at least the graph's weight
/// parts  at least 1, at most the number of vertices
[[nodiscard]] KwayResult multilevel_kway(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
                                         const KwaySettings& settings, std::uint64_t seed,
                                         const Progress& progress);

}  // namespace leonhard::graph::detail
