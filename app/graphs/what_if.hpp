// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "leonhard/app/graphs/partition_request.hpp"
#include "leonhard/app/report/json.hpp"
#include "leonhard/graph/communication.hpp"

namespace leonhard::app {

/// What a step of a parallel program costs: to exchange the values next to each part, and to compute.
struct StepCost {
  graph::MessageCost message{1e-6, 1e-9};
  double work = 0;  ///< seconds to compute at one vertex of weight 1; 0: not known
};

/// throws  InputError if a cost is negative or not finite
void check_step_cost(const StepCost& cost);

/// A number of processors, and what would happen with so many.
struct WhatIf {
  graph::PartitionOutcome outcome{};
  graph::PartitionCost partition;
  std::uint32_t parts{};
  bool fewest_cycles = false;  ///< no schedule of fewer cycles exists
  graph::CommunicationCost exchange;
  double partition_seconds{};  ///< that the partitioning took
  double step_seconds{};       ///< work of the heaviest part, and the exchange
  double speedup{};            ///< all work over step_seconds; 0 if the work is not known
};

/// throws  InputError if a number is 0 or larger than the number of vertices
void check_what_if(const AnyGraph& input, std::span<const std::uint32_t> numbers);

/// Part the graph into one number of parts after another, and reckon. Nothing is run in parallel.
///
/// throws  InputError before any work as check_what_if; as the partitioner
/// Stops after the number at which stop is requested.
[[nodiscard]] std::vector<WhatIf> what_if(const AnyGraph& input, const Partitioner& part,
                                          std::span<const std::uint32_t> numbers, const StepCost& cost,
                                          std::stop_token stop);

[[nodiscard]] Json to_json(const std::vector<WhatIf>& table);
[[nodiscard]] std::string what_if_text(const std::vector<WhatIf>& table);

}  // namespace leonhard::app
