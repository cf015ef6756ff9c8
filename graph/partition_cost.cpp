// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "leonhard/graph/partition.hpp"
#include "leonhard/graph/partition/partition_checks.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

void check_as_many(std::span<const std::uint32_t> weights, std::size_t expected, const char* what) {
  if (weights.empty() || weights.size() == expected) return;
  throw InputError("weights",
                   std::to_string(weights.size()) + " weights for " + std::to_string(expected) + " " + what,
                   "give one each, or none");
}

/// Pieces of each part: components of the graph without its cut edges.
std::vector<std::uint32_t> pieces_per_part(const CsrGraph& graph, const PartitionView& partition) {
  std::vector<std::uint32_t> pieces(partition.parts, 0), stack;
  std::vector<bool> seen(partition.part_of.size(), false);
  for (std::uint32_t root = 0; root < seen.size(); ++root) {
    if (seen[root]) continue;
    const std::uint32_t part = partition.part_of[root];
    ++pieces[part];
    seen[root] = true;
    stack.push_back(root);
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      for (const std::uint32_t w : neighbours(graph, v))
        if (!seen[w] && partition.part_of[w] == part) {
          seen[w] = true;
          stack.push_back(w);
        }
    }
  }
  return pieces;
}

/// (part, foreign vertex next to it), each once, sorted.
std::vector<std::pair<std::uint32_t, std::uint32_t>> halo_pairs(const CsrGraph& graph,
                                                                const PartitionView& partition) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v))
      if (partition.part_of[w] != partition.part_of[v]) pairs.emplace_back(partition.part_of[w], v);
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

PartitionCost partition_cost(const CsrGraph& graph, const PartitionView& partition,
                             std::span<const std::uint32_t> vertex_weights,
                             std::span<const std::uint32_t> edge_weights) {
  const std::uint32_t n = vertex_count(graph), parts = partition.parts;
  detail::check_partition(partition, n, "vertices");
  check_as_many(vertex_weights, n, "vertices");
  check_as_many(edge_weights, 2 * edge_count(graph), "directed edges");
  PartitionCost cost;
  cost.sizes.assign(parts, 0);
  for (const std::uint32_t part : partition.part_of) ++cost.sizes[part];
  const auto [least, most] = std::ranges::minmax_element(cost.sizes);
  cost.smallest = *least;
  cost.largest = *most;
  cost.weights.assign(parts, 0);
  std::uint64_t total = 0;
  for (std::uint32_t v = 0; v < n; ++v) {
    const std::uint32_t weight = vertex_weights.empty() ? 1 : vertex_weights[v];
    cost.weights[partition.part_of[v]] += weight;
    total += weight;
  }
  if (total > 0)
    cost.imbalance =
        static_cast<double>(std::ranges::max(cost.weights)) * parts / static_cast<double>(total) - 1;
  cost.components = pieces_per_part(graph, partition);

  std::size_t arc = 0;
  for (std::uint32_t v = 0; v < n; ++v)
    for (const std::uint32_t w : neighbours(graph, v)) {
      const std::uint32_t weight = edge_weights.empty() ? 1 : edge_weights[arc];
      ++arc;
      if (v > w || partition.part_of[v] == partition.part_of[w]) continue;
      ++cost.cut;
      cost.cut_weight += weight;
    }

  cost.halo.assign(parts, 0);
  cost.neighbours.assign(parts, 0);
  const auto pairs = halo_pairs(graph, partition);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touching;  // (part, other part)
  for (const auto& [part, vertex] : pairs) {
    ++cost.halo[part];
    touching.emplace_back(part, partition.part_of[vertex]);
  }
  std::ranges::sort(touching);
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  for (const auto& pair : touching) ++cost.neighbours[pair.first];
  cost.total_halo = pairs.size();
  cost.max_halo = std::ranges::max(cost.halo);
  cost.max_neighbours = std::ranges::max(cost.neighbours);
  cost.max_components = std::ranges::max(cost.components);
  return cost;
}

}  // namespace leonhard::graph
