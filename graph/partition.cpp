// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/partition/connected_parts.hpp"
#include "leonhard/graph/partition/kway.hpp"
#include "leonhard/graph/partition/kway_balance.hpp"
#include "leonhard/graph/partition/partition_checks.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

/// The points of a geometric method, one a vertex.
template <class Method>
Partition by_coordinates(const CsrGraph& graph, const PartitionOptions& options, const Method& method) {
  const std::size_t given = std::visit([](const auto& points) { return points.size(); }, options.coordinates);
  if (given != vertex_count(graph))
    throw InputError(
        "coordinates",
        std::to_string(given) + " points for " + std::to_string(vertex_count(graph)) + " vertices",
        "give one a vertex, or take a method that needs none");
  return std::visit(method, options.coordinates);
}

Partition by_method(const CsrGraph& graph, const detail::KwayGraph& weighted, std::uint32_t parts,
                    const PartitionOptions& options, std::int64_t limit) {
  const auto weights = options.vertex_weights;
  switch (options.method) {
    case PartitionMethod::coordinate:
      return by_coordinates(graph, options, [&](const auto& points) {
        return recursive_coordinate_bisection(points, parts, weights);
      });
    case PartitionMethod::inertial:
      return by_coordinates(graph, options, [&](const auto& points) {
        return recursive_inertial_bisection(points, parts, weights);
      });
    case PartitionMethod::cuthill_mckee:
    case PartitionMethod::cuthill_mckee_levels:
      return recursive_cuthill_mckee_bisection(graph, parts,
                                               options.method == PartitionMethod::cuthill_mckee
                                                   ? CuthillMcKeeCut::median
                                                   : CuthillMcKeeCut::level_set,
                                               {options.imbalance, weights, options.progress});
    case PartitionMethod::spectral:
      return recursive_spectral_bisection(graph, parts, options.seed, options.progress, weights);
    case PartitionMethod::multilevel:
      break;
  }
  detail::KwayResult found = detail::multilevel_kway(
      weighted, parts, limit, detail::settings_of(options.effort), options.seed, options.progress);
  return {parts, std::move(found.part_of),
          found.stopped ? PartitionOutcome::stopped : PartitionOutcome::done};
}

}  // namespace

std::int64_t heaviest_allowed(std::int64_t weight, std::uint32_t parts, double imbalance) {
  if (parts == 0) throw InputError("parts", "a partition into 0 parts", "ask for at least 1");
  if (!(imbalance >= 0) || !std::isfinite(imbalance))
    throw InputError("imbalance", "it is " + std::to_string(imbalance), "give 0 or more");
  const std::int64_t even = weight / parts + (weight % parts == 0 ? 0 : 1);
  const double bound = std::floor((1 + imbalance) * static_cast<double>(weight) / parts);
  return std::max(even, bound >= static_cast<double>(weight) ? weight : static_cast<std::int64_t>(bound));
}

Partition partition(const CsrGraph& graph, std::uint32_t parts, const PartitionOptions& options) {
  detail::check_partition_request(graph, parts, options);
  const detail::KwayGraph weighted =
      detail::weighted_graph(graph, options.vertex_weights, options.edge_weights);
  const std::int64_t limit = heaviest_allowed(weighted.total_weight, parts, options.imbalance);
  Partition result = by_method(graph, weighted, parts, options, limit);
  const bool balanced = detail::keep_limit(weighted, parts, limit, result.part_of);
  bool connected = true;
  if (options.connected && result.outcome == PartitionOutcome::done)
    connected = detail::connect_parts(weighted, parts, limit, result.part_of, options.progress.stop);
  if (result.outcome == PartitionOutcome::done && !balanced) result.outcome = PartitionOutcome::unbalanced;
  if (result.outcome == PartitionOutcome::done && !connected) result.outcome = PartitionOutcome::disconnected;
  return result;
}

}  // namespace leonhard::graph
