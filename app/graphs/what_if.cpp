// SPDX-License-Identifier: MIT
#include "leonhard/app/graphs/what_if.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "leonhard/app/console.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

WhatIf reckon(const AnyGraph& input, const Partitioner& part, std::uint32_t parts, const StepCost& cost) {
  WhatIf row;
  row.parts = parts;
  const auto start = std::chrono::steady_clock::now();
  const graph::Partition partition = part(parts);
  row.partition_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  row.outcome = partition.outcome;
  row.partition = part.cost_of(partition);
  const auto schedule = graph::communication_schedule(graph::communication_graph(input.graph, partition));
  row.fewest_cycles = schedule.colouring.certain;
  row.exchange = graph::communication_cost(schedule, cost.message);
  const auto& weights = row.partition.weights;
  const double heaviest = static_cast<double>(std::ranges::max(weights));
  const double all = static_cast<double>(std::accumulate(weights.begin(), weights.end(), std::uint64_t{0}));
  row.step_seconds = cost.work * heaviest + row.exchange.synchronous_seconds;
  if (cost.work > 0) row.speedup = cost.work * all / row.step_seconds;
  return row;
}

}  // namespace

void check_step_cost(const StepCost& cost) {
  const auto check = [](const char* option, double seconds) {
    if (!(seconds >= 0) || !std::isfinite(seconds))
      throw InputError(option, fmt::format("{} seconds", seconds), "give 0 or a finite time");
  };
  check("--alpha", cost.message.alpha);
  check("--beta", cost.message.beta);
  check("--work", cost.work);
}

void check_what_if(const AnyGraph& input, std::span<const std::uint32_t> numbers) {
  const std::uint32_t vertices = graph::vertex_count(input.graph);
  for (const std::uint32_t parts : numbers)
    if (parts < 1 || parts > vertices)
      throw InputError("--what-if", fmt::format("{} parts of {} vertices", parts, vertices),
                       "give numbers from 1 to the number of vertices");
}

std::vector<WhatIf> what_if(const AnyGraph& input, const Partitioner& part,
                            std::span<const std::uint32_t> numbers, const StepCost& cost,
                            std::stop_token stop) {
  check_what_if(input, numbers);
  std::vector<WhatIf> table;
  for (const std::uint32_t parts : numbers) {
    table.push_back(reckon(input, part, parts, cost));
    if (stop.stop_requested()) break;
  }
  return table;
}

Json to_json(const std::vector<WhatIf>& table) {
  Json list = Json::array();
  for (const WhatIf& row : table) {
    Json line{{"parts", row.parts},
              {"outcome", to_string(row.outcome)},
              {"cut", row.partition.cut},
              {"imbalance", row.partition.imbalance},
              {"largest", row.partition.largest},
              {"max_neighbours", row.partition.max_neighbours},
              {"max_halo", row.partition.max_halo},
              {"total_halo", row.partition.total_halo},
              {"cycles", row.exchange.cycles},
              {"fewest_cycles", row.fewest_cycles},
              {"values", row.exchange.values},
              {"longest_message", row.exchange.longest_message},
              {"synchronous_seconds", row.exchange.synchronous_seconds},
              {"busiest_part_seconds", row.exchange.busiest_part_seconds},
              {"partition_seconds", row.partition_seconds}};
    if (row.speedup > 0) {
      line["step_seconds"] = row.step_seconds;
      line["speedup"] = row.speedup;
      line["efficiency"] = row.speedup / row.parts;
    }
    list.push_back(std::move(line));
  }
  return list;
}

std::string what_if_text(const std::vector<WhatIf>& table) {
  const bool works = std::ranges::any_of(table, [](const WhatIf& row) { return row.speedup > 0; });
  std::string text = fmt::format("{:>9}{:>13}{:>10}{:>9}{:>12}{:>8}{:>13}{:>9}{:>13}{:>10}", "parts",
                                 "cut edges", "imbalance", "largest", "neighbours", "cycles", "values sent",
                                 "longest", "exchange, s", "parted, s");
  text += works ? fmt::format("{:>11}{:>10}{:>12}\n", "step, s", "speedup", "efficiency") : "\n";
  for (const WhatIf& row : table) {
    text += fmt::format("{:>9}{:>13}{:>10.4f}{:>9}{:>12}{:>8}{:>13}{:>9}{:>13.3g}{:>10.2f}",
                        grouped(row.parts), grouped(row.partition.cut), row.partition.imbalance,
                        grouped(row.partition.largest), row.partition.max_neighbours, row.exchange.cycles,
                        grouped(row.exchange.values), grouped(row.exchange.longest_message),
                        row.exchange.synchronous_seconds, row.partition_seconds);
    text += works ? fmt::format("{:>11.3g}{:>10.1f}{:>10.1f} %\n", row.step_seconds, row.speedup,
                                100 * row.speedup / row.parts)
                  : "\n";
  }
  return text;
}

}  // namespace leonhard::app
