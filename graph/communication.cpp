// SPDX-License-Identifier: MIT
#include "leonhard/graph/communication.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "leonhard/graph/partition/partition_checks.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

/// Source, target and vertex of everything that is sent, each once, ascending.
std::vector<std::array<std::uint32_t, 3>> values_sent(const CsrGraph& graph, const PartitionView& partition) {
  std::vector<std::array<std::uint32_t, 3>> sent;
  std::vector<std::uint32_t> targets;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) {
    const std::uint32_t own = partition.part_of[v];
    targets.clear();
    for (const std::uint32_t w : neighbours(graph, v))
      if (partition.part_of[w] != own) targets.push_back(partition.part_of[w]);
    std::ranges::sort(targets);
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    for (const std::uint32_t target : targets) sent.push_back({own, target, v});
  }
  std::ranges::sort(sent);
  return sent;
}

std::uint64_t longest(const Exchange& exchange) { return std::max(exchange.forwards, exchange.backwards); }

std::uint64_t longest(const std::vector<Exchange>& cycle) {
  std::uint64_t length = 0;
  for (const Exchange& exchange : cycle) length = std::max(length, longest(exchange));
  return length;
}

}  // namespace

CommunicationGraph communication_graph(const CsrGraph& graph, const PartitionView& partition) {
  detail::check_partition(partition, vertex_count(graph), "vertices");
  CommunicationGraph result;
  CsrGraph::Rows targets;
  const auto sent = values_sent(graph, partition);
  auto value = sent.begin();
  for (std::uint32_t part = 0; part < partition.parts; ++part) {
    for (; value != sent.end() && (*value)[0] == part; ++value) {
      const bool new_message =
          value == sent.begin() || (*value)[0] != (*(value - 1))[0] || (*value)[1] != (*(value - 1))[1];
      if (new_message) {
        targets.add_link((*value)[1]);
        result.message.push_back(0);
      }
      ++result.message.back();
    }
    targets.end_row();
  }
  result.graph = CsrGraph(std::move(targets));
  return result;
}

CommunicationSchedule communication_schedule(const CommunicationGraph& communication,
                                             const EdgeColouringOptions& options) {
  const CsrGraph& graph = communication.graph;
  CommunicationSchedule schedule;
  schedule.colouring = colour_edges(graph, options);
  schedule.cycles.resize(schedule.colouring.colours);
  std::vector<std::size_t> row(vertex_count(graph) + std::size_t{1}, 0);  // where each part's messages begin
  for (std::uint32_t p = 0; p < vertex_count(graph); ++p) row[p + std::size_t{1}] = row[p] + degree(graph, p);
  std::size_t edge = 0;
  for (std::uint32_t p = 0; p < vertex_count(graph); ++p) {
    const auto list = neighbours(graph, p);
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::uint32_t q = list[k];
      if (q < p) continue;
      const auto back = std::ranges::lower_bound(neighbours(graph, q), p) - neighbours(graph, q).begin();
      schedule.cycles[schedule.colouring.colour_of[edge++]].push_back(
          {p, q, communication.message[row[p] + k],
           communication.message[row[q] + static_cast<std::size_t>(back)]});
    }
  }
  std::ranges::stable_sort(schedule.cycles, std::ranges::greater{},
                           [](const std::vector<Exchange>& cycle) { return longest(cycle); });
  return schedule;
}

CommunicationCost communication_cost(const CommunicationSchedule& schedule, const MessageCost& cost) {
  for (const double seconds : {cost.alpha, cost.beta})
    if (!std::isfinite(seconds) || seconds < 0)
      throw InputError(
          "cost", "alpha is " + std::to_string(cost.alpha) + " s, beta " + std::to_string(cost.beta) + " s",
          "both must be finite and not negative");
  CommunicationCost result;
  result.cycles = static_cast<std::uint32_t>(schedule.cycles.size());
  std::vector<double> busy;
  for (const std::vector<Exchange>& cycle : schedule.cycles) {
    if (!cycle.empty()) result.synchronous_seconds += cost(longest(cycle));
    for (const Exchange& exchange : cycle) {
      const double seconds = cost(longest(exchange));
      if (busy.size() <= exchange.second) busy.resize(exchange.second + std::size_t{1}, 0);
      busy[exchange.first] += seconds;
      busy[exchange.second] += seconds;
      result.values += exchange.forwards + exchange.backwards;
      result.longest_message = std::max(result.longest_message, longest(exchange));
      result.all_messages_seconds += seconds;
    }
  }
  for (const double seconds : busy)
    result.busiest_part_seconds = std::max(result.busiest_part_seconds, seconds);
  return result;
}

}  // namespace leonhard::graph
