// SPDX-License-Identifier: MIT
#include "leonhard/app/report/communication_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "leonhard/app/console.hpp"

namespace leonhard::app {
namespace {

constexpr std::size_t most_lines = 40;

std::vector<std::uint64_t> values_sent(const Communication& communication) {
  const graph::CsrGraph& graph = communication.graph.graph;
  std::vector<std::uint64_t> sent;
  auto message = communication.graph.message.begin();
  for (std::uint32_t part = 0; part < graph::vertex_count(graph); ++part) {
    const auto next = message + graph::degree(graph, part);
    sent.push_back(std::accumulate(message, next, std::uint64_t{0}));
    message = next;
  }
  return sent;
}

std::size_t exchange_count(const Communication& communication) {
  return graph::edge_count(communication.graph.graph);
}

std::string cycles_text(const graph::CommunicationSchedule& schedule) {
  std::string text;
  for (std::size_t c = 0; c < schedule.cycles.size(); ++c) {
    text += fmt::format("{:<12}", fmt::format("cycle {}", c + 1));
    for (const graph::Exchange& exchange : schedule.cycles[c])
      text += fmt::format("{}-{} ({}/{})  ", exchange.first, exchange.second, exchange.forwards,
                          exchange.backwards);
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

}  // namespace

Communication communication_of(const graph::CsrGraph& graph, const graph::Partition& partition,
                               const graph::MessageCost& message_cost,
                               const graph::EdgeColouringOptions& options) {
  Communication result;
  result.message_cost = message_cost;
  result.graph = graph::communication_graph(graph, partition);
  result.schedule = graph::communication_schedule(result.graph, options);
  result.cost = graph::communication_cost(result.schedule, message_cost);
  return result;
}

Json to_json(const Communication& communication) {
  Json cycles = Json::array();
  for (const auto& cycle : communication.schedule.cycles) {
    Json exchanges = Json::array();
    for (const graph::Exchange& exchange : cycle)
      exchanges.push_back({{"first", exchange.first},
                           {"second", exchange.second},
                           {"forwards", exchange.forwards},
                           {"backwards", exchange.backwards}});
    cycles.push_back(std::move(exchanges));
  }
  return {{"exchanges", exchange_count(communication)},
          {"cycle_count", communication.cost.cycles},
          {"fewest_cycles", communication.schedule.colouring.certain},
          {"values", communication.cost.values},
          {"longest_message", communication.cost.longest_message},
          {"alpha", communication.message_cost.alpha},
          {"beta", communication.message_cost.beta},
          {"synchronous_seconds", communication.cost.synchronous_seconds},
          {"busiest_part_seconds", communication.cost.busiest_part_seconds},
          {"all_messages_seconds", communication.cost.all_messages_seconds},
          {"values_sent", values_sent(communication)},
          {"cycles", std::move(cycles)}};
}

std::string communication_text(const Communication& communication) {
  const graph::CommunicationCost& cost = communication.cost;
  std::string text =
      fmt::format("{:<12}{} pairs of parts in {} cycles{}; {} values, {} in the longest message\n",
                  "exchange", grouped(exchange_count(communication)), cost.cycles,
                  communication.schedule.colouring.certain ? ", the fewest there can be" : "",
                  grouped(cost.values), grouped(cost.longest_message));
  text += fmt::format(
      "{:<12}{:.4g} s cycle by cycle; no schedule takes less than {:.4g} s; {:.4g} s one after another\n",
      "cost", cost.synchronous_seconds, cost.busiest_part_seconds, cost.all_messages_seconds);
  text += fmt::format("{:<12}{:g} s a message and {:g} s a value\n", "", communication.message_cost.alpha,
                      communication.message_cost.beta);
  if (exchange_count(communication) <= 5 * most_lines) text += cycles_text(communication.schedule);
  return text;
}

std::string parts_text(const graph::PartitionCost& cost, const Communication& communication,
                       std::string_view of) {
  const std::vector<std::uint64_t> sent = values_sent(communication);
  std::vector<std::size_t> shown(cost.sizes.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  std::string text;
  if (shown.size() > most_lines) {
    std::ranges::stable_sort(shown, std::greater{}, [&](std::size_t part) { return cost.halo[part]; });
    shown.resize(most_lines);
    text = fmt::format("the {} parts of the largest halos:\n", most_lines);
  }
  const double all =
      static_cast<double>(std::accumulate(cost.weights.begin(), cost.weights.end(), std::uint64_t{0}));
  const auto to_mean = [&](std::size_t part) {
    return all > 0 ? static_cast<double>(cost.weights[part]) * static_cast<double>(cost.sizes.size()) / all
                   : 1;
  };
  text += fmt::format("{:>8}{:>12}{:>10}{:>8}{:>12}{:>10}{:>10}\n", "part", of, "to mean", "pieces",
                      "neighbours", "halo", "sends");
  for (const std::size_t part : shown)
    text += fmt::format("{:>8}{:>12}{:>10.4f}{:>8}{:>12}{:>10}{:>10}\n", part, grouped(cost.sizes[part]),
                        to_mean(part), cost.components[part], cost.neighbours[part], grouped(cost.halo[part]),
                        grouped(sent[part]));
  return text;
}

}  // namespace leonhard::app
