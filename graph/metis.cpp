// SPDX-License-Identifier: MIT
#include "leonhard/graph/metis.hpp"

#include <metis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/partition/partition_checks.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

/// A graph as METIS wants it.
struct MetisGraph {
  std::vector<idx_t> start, to, edge_weight, vertex_weight;

  explicit MetisGraph(const detail::KwayGraph& graph)
      : start(graph.arcs.offsets().begin(), graph.arcs.offsets().end()),
        vertex_weight(graph.vertex_weight.begin(), graph.vertex_weight.end()) {
    for (const detail::Arc& arc : graph.arcs.links()) {
      to.push_back(static_cast<idx_t>(arc.to));
      edge_weight.push_back(arc.weight);
    }
  }
};

}  // namespace

Partition partition_with_metis(const CsrGraph& graph, std::uint32_t parts, const PartitionOptions& options,
                               MetisScheme scheme) {
  detail::check_partition_request(graph, parts, options);
  const detail::KwayGraph weighted =
      detail::weighted_graph(graph, options.vertex_weights, options.edge_weights);
  Partition result{parts, std::vector<std::uint32_t>(weighted.size(), 0), PartitionOutcome::done};
  if (parts == 1) return result;
  MetisGraph input(weighted);
  std::array<idx_t, METIS_NOPTIONS> settings{};
  METIS_SetDefaultOptions(settings.data());
  settings[METIS_OPTION_SEED] = static_cast<idx_t>(options.seed);
  settings[METIS_OPTION_UFACTOR] = std::max(1, static_cast<idx_t>(std::lround(1000 * options.imbalance)));
  if (scheme == MetisScheme::k_way) settings[METIS_OPTION_CONTIG] = options.connected ? 1 : 0;
  idx_t n = static_cast<idx_t>(weighted.size()), constraints = 1, k = static_cast<idx_t>(parts), cut = 0;
  std::vector<idx_t> part(weighted.size());
  const auto method = scheme == MetisScheme::k_way ? METIS_PartGraphKway : METIS_PartGraphRecursive;
  const int status =
      method(&n, &constraints, input.start.data(), input.to.data(), input.vertex_weight.data(), nullptr,
             input.edge_weight.data(), &k, nullptr, nullptr, settings.data(), &cut, part.data());
  if (status != METIS_OK)
    throw InputError("graph", "METIS refuses it with status " + std::to_string(status),
                     options.connected ? "METIS makes connected parts of connected graphs only" : "");
  result.part_of.assign(part.begin(), part.end());
  const auto weights = detail::part_weights(weighted, result.part_of, parts);
  if (std::ranges::max(weights) > heaviest_allowed(weighted.total_weight, parts, options.imbalance))
    result.outcome = PartitionOutcome::unbalanced;
  return result;
}

}  // namespace leonhard::graph
