// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "leonhard/app/report/json.hpp"
#include "leonhard/graph/communication.hpp"
#include "leonhard/graph/partition.hpp"

namespace leonhard::app {

/// The communication graph of a partition, its schedule and what it costs.
struct Communication {
  graph::CommunicationGraph graph;
  graph::CommunicationSchedule schedule;
  graph::MessageCost message_cost;
  graph::CommunicationCost cost;
};

/// throws  InputError if alpha or beta is negative or not finite
[[nodiscard]] Communication communication_of(const graph::CsrGraph& graph, const graph::Partition& partition,
                                             const graph::MessageCost& message_cost,
                                             const graph::EdgeColouringOptions& options);

/// Counts, costs, and all exchanges cycle by cycle.
[[nodiscard]] Json to_json(const Communication& communication);

/// The same for people, with the exchanges if all of them fit some lines.
[[nodiscard]] std::string communication_text(const Communication& communication);

/// A line a part: vertices (named `of`, see vertices_are), weight over the mean weight, pieces, neighbours, halo, values sent; of the largest 40 parts
/// those with the longest halo.
[[nodiscard]] std::string parts_text(const graph::PartitionCost& cost, const Communication& communication,
                                     std::string_view of);

}  // namespace leonhard::app
