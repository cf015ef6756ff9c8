// SPDX-License-Identifier: MIT
#include "leonhard/app/report/partition_report.hpp"

#include <fmt/format.h>

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

std::string partition_report_text(const Json& report) {
  const auto count = [&](const char* key) { return grouped(report[key].get<std::uint64_t>()); };
  const auto of = report["of"].get<std::string>();
  std::string text = graph_text(report["vertices"], report["edges"], of);
  text += fmt::format("{:<12}{} by {}: {}\n", "parts", count("parts"), report["method"].get<std::string>(),
                      report["outcome"].get<std::string>());
  text += fmt::format("{:<12}{} edges, weight {}\n", "cut", count("cut"), count("cut_weight"));
  text += fmt::format("{:<12}{} to {} {}, imbalance {:.4f} (allowed {:g})\n", "balance", count("smallest"),
                      count("largest"), of, report["imbalance"].get<double>(),
                      report["imbalance_allowed"].get<double>());
  text += fmt::format("{:<12}{} at most in a part\n", "components", count("max_components"));
  text += fmt::format("{:<12}{} at most\n", "neighbours", count("max_neighbours"));
  text += fmt::format("{:<12}{} {} at most, {} in all\n", "halo", count("max_halo"), of, count("total_halo"));
  return text;
}

}  // namespace leonhard::app
