// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <stop_token>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/multilevel/kway_random.hpp"
#include "leonhard/graph/separator/separator_fm.hpp"

namespace leonhard::graph::detail {

/// A separator and what it is worth.
struct FoundSeparator {
  Sides side;
  SeparatorQuality quality{};
};

/// throws  InputError if largest_side is not in (1/2, 1] or tries is 0
void check_separator_options(double largest_side, std::uint32_t tries);

/// The best of several separators of a graph with weights.
///
/// largest_side  of the graph's weight; it and tries as check_separator_options wants them
/// tries         Large graphs are coarsened once to a size at which many tries cost little.
/// Method: as vertex_separator.
[[nodiscard]] FoundSeparator multilevel_separator(const KwayGraph& graph, double largest_side,
                                                  std::uint32_t tries, Random& random,
                                                  const std::stop_token& stop);

}  // namespace leonhard::graph::detail
