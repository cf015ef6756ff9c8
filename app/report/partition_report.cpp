// SPDX-License-Identifier: MIT
#include "leonhard/app/report/partition_report.hpp"

#include <fmt/core.h>

#include "leonhard/app/console.hpp"

namespace leonhard::app {

Json partition_report(const graph::Partition& partition, const graph::PartitionCost& cost,
                      const PartitionRequest& request) {
  return {{"method", request.method},
          {"effort", request.effort},
          {"parts", partition.parts},
          {"outcome", to_string(partition.outcome)},
          {"cut", cost.cut},
          {"cut_weight", cost.cut_weight},
          {"imbalance", cost.imbalance},
          {"imbalance_allowed", request.imbalance},
          {"smallest", cost.smallest},
          {"largest", cost.largest},
          {"max_components", cost.max_components},
          {"max_neighbours", cost.max_neighbours},
          {"max_halo", cost.max_halo},
          {"total_halo", cost.total_halo},
          {"sizes", cost.sizes},
          {"weights", cost.weights},
          {"components", cost.components},
          {"neighbours", cost.neighbours},
          {"halo", cost.halo}};
}

std::string partition_report_text(const graph::Partition& partition, const graph::PartitionCost& cost,
                                  const PartitionRequest& request, std::string_view of) {
  std::string text = fmt::format("{:<12}{} by {}: {}\n", "parts", grouped(partition.parts), request.method,
                                 to_string(partition.outcome));
  text += fmt::format("{:<12}{} edges, weight {}\n", "cut", grouped(cost.cut), grouped(cost.cut_weight));
  text += fmt::format("{:<12}{} to {} {}, imbalance {:.4f} (allowed {:g})\n", "balance",
                      grouped(cost.smallest), grouped(cost.largest), of, cost.imbalance, request.imbalance);
  text += fmt::format("{:<12}{} at most in a part\n", "components", grouped(cost.max_components));
  text += fmt::format("{:<12}{} at most\n", "neighbours", grouped(cost.max_neighbours));
  text += fmt::format("{:<12}{} {} at most, {} in all\n", "halo", grouped(cost.max_halo), of,
                      grouped(cost.total_halo));
  return text;
}

}  // namespace leonhard::app
