// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "leonhard/graph/colouring.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition_parts.hpp"

/// What the parts of a partition tell one another, in which sequence, and how long that takes (Barth's notes 2.3).
namespace leonhard::graph {

/// The communication graph: one vertex a part, an edge between parts that share cut edges.
struct CommunicationGraph {
  CsrGraph graph;
  /// Message lengths, one a directed edge in the graph's order: how many vertices of the source have a neighbour in
  /// the target, each of which sends one value.
  std::vector<std::uint64_t> message;
};

/// throws  InputError if the partition has not one entry a vertex or names a part out of range
/// Cost O(n + m + parts), and a sort of the cut edges.
[[nodiscard]] CommunicationGraph communication_graph(const CsrGraph& graph, const PartitionView& partition);

/// Two parts that send each other a message at the same time.
struct Exchange {
  std::uint32_t first, second;        ///< parts, first < second
  std::uint64_t forwards, backwards;  ///< lengths of the messages first -> second and back
};

/// The exchanges in cycles: in each cycle a part takes part in one exchange at most.
struct CommunicationSchedule {
  std::vector<std::vector<Exchange>> cycles;
  EdgeColouring colouring;  ///< from which they came, of the communication graph's edges
};

/// As few cycles as colour_edges finds colours: the largest number of neighbours of a part, or one more. The longest
/// cycles come first.
[[nodiscard]] CommunicationSchedule communication_schedule(const CommunicationGraph& communication,
                                                           const EdgeColouringOptions& options = {});

/// The time of a message of m values is alpha + beta m (equation 2.3.0).
struct MessageCost {
  double alpha;  ///< seconds to begin a message
  double beta;   ///< seconds a value
  [[nodiscard]] double operator()(std::uint64_t values) const {
    return alpha + beta * static_cast<double>(values);
  }
};

/// What one exchange of all halos costs, both directions of an exchange going on at the same time.
struct CommunicationCost {
  std::uint32_t cycles{};
  std::uint64_t values{};  ///< sent by all parts together
  std::uint64_t longest_message{};
  double synchronous_seconds{};  ///< sum over the cycles of their longest exchange: all parts wait for all
  double
      busiest_part_seconds{};  ///< largest sum over a part's exchanges (equation 2.3.1): no schedule is faster
  double all_messages_seconds{};  ///< sum over all exchanges, as if one after another
};

/// throws  InputError if alpha or beta is negative or not finite
/// Cost O(exchanges + parts).
[[nodiscard]] CommunicationCost communication_cost(const CommunicationSchedule& schedule,
                                                   const MessageCost& cost);

}  // namespace leonhard::graph
