// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "leonhard/graph/partition/kway_flow.hpp"
#include "leonhard/graph/partition_options.hpp"

namespace leonhard::graph::detail {

/// How a graph is halved.
struct BisectionSettings {
  std::uint32_t coarsest = 120;  ///< vertices of the coarsest level
  std::uint32_t tries = 4;       ///< bisections grown there, of which the best is kept
  std::uint32_t repeats = 4;     ///< whole multilevel bisections, of which the best is kept
};

/// How a partition is refined on one level.
struct RefinementSettings {
  std::uint32_t patience = 3;   ///< moves without a better cut that end a local search
  std::uint32_t searches = 3;   ///< rounds of local searches at most
  std::uint32_t flows = 1;      ///< rounds of flows at most
  KwayFlow::Strip strip{3, 6};  ///< of the flows
};

/// How hard the multilevel k-way partitioner tries.
struct KwaySettings {
  std::uint32_t coarsest = 1000;         ///< the coarsest level has this many vertices,
  std::uint32_t coarsest_per_part = 50;  ///< or this many a part if that is more
  BisectionSettings bisection;
  std::uint32_t coarse_population = 1;    ///< partitions of the coarsest level made independently
  std::uint32_t coarse_combinations = 0;  ///< times that two of them are combined into one
  RefinementSettings coarse, finest;      ///< on the levels below the finest, and on it
  std::uint32_t population = 1;           ///< partitions of the whole, and as above
  std::uint32_t combinations = 0;
};

[[nodiscard]] KwaySettings settings_of(Effort effort);

}  // namespace leonhard::graph::detail
