// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/support/step_counter.hpp"

namespace leonhard::graph::detail {

/// A level structure made of two, from both ends of a graph: neighbours lie on one level or on adjacent ones.
struct CombinedLevels {
  std::uint32_t root{};                 ///< on level 0
  std::uint32_t depth{};                ///< levels less one
  std::vector<std::uint32_t> level_of;  ///< one a vertex
};

/// The combined level structure of a connected graph, no wider than needed, from the end of lesser degree. Not for
/// callers outside this room.
///
/// steps  if it was stopped the result is of no use
/// Method: Gibbs, Poole and Stockmeyer, SIAM J. Numer. Anal. 13 (1976) 236-250, algorithms I and II.
[[nodiscard]] CombinedLevels combined_levels(const CsrGraph& graph, StepCounter& steps);

}  // namespace leonhard::graph::detail
