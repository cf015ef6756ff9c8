// SPDX-License-Identifier: MIT
#include "leonhard/graph/scotch.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>

extern "C" {
#include <scotch.h>
}

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/partition/partition_checks.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

/// Scotch's graph and strategy, released at the end of the scope.
struct Scotch {
  SCOTCH_Graph graph;
  SCOTCH_Strat strategy;

  Scotch() {
    SCOTCH_graphInit(&graph);
    SCOTCH_stratInit(&strategy);
  }
  ~Scotch() {
    SCOTCH_stratExit(&strategy);
    SCOTCH_graphExit(&graph);
  }
  Scotch(const Scotch&) = delete;
  Scotch& operator=(const Scotch&) = delete;
};

}  // namespace

Partition partition_with_scotch(const CsrGraph& graph, std::uint32_t parts, const PartitionOptions& options) {
  detail::check_partition_request(graph, parts, options);
  const detail::KwayGraph weighted =
      detail::weighted_graph(graph, options.vertex_weights, options.edge_weights);
  Partition result{parts, std::vector<std::uint32_t>(weighted.size(), 0), PartitionOutcome::done};
  if (parts == 1) return result;
  const auto offsets = weighted.arcs.offsets();
  std::vector<SCOTCH_Num> start(offsets.begin(), offsets.end()), to, edge_weight,
      vertex_weight(weighted.vertex_weight.begin(), weighted.vertex_weight.end());
  for (const detail::Arc& arc : weighted.arcs.links()) {
    to.push_back(static_cast<SCOTCH_Num>(arc.to));
    edge_weight.push_back(arc.weight);
  }
  std::vector<SCOTCH_Num> part(weighted.size());
  Scotch scotch;
  SCOTCH_randomSeed(static_cast<SCOTCH_Num>(options.seed));
  SCOTCH_randomReset();
  const SCOTCH_Num flags = options.effort == Effort::high ? SCOTCH_STRATQUALITY : SCOTCH_STRATDEFAULT;
  const bool failed =
      SCOTCH_graphBuild(&scotch.graph, 0, static_cast<SCOTCH_Num>(weighted.size()), start.data(), nullptr,
                        vertex_weight.data(), nullptr, static_cast<SCOTCH_Num>(to.size()), to.data(),
                        edge_weight.data()) != 0 ||
      SCOTCH_stratGraphMapBuild(&scotch.strategy, flags, static_cast<SCOTCH_Num>(parts), options.imbalance) !=
          0 ||
      SCOTCH_graphPart(&scotch.graph, static_cast<SCOTCH_Num>(parts), &scotch.strategy, part.data()) != 0;
  if (failed) throw InputError("graph", "Scotch refuses it", "");
  result.part_of.assign(part.begin(), part.end());
  const auto weights = detail::part_weights(weighted, result.part_of, parts);
  if (std::ranges::max(weights) > heaviest_allowed(weighted.total_weight, parts, options.imbalance))
    result.outcome = PartitionOutcome::unbalanced;
  return result;
}

}  // namespace leonhard::graph
