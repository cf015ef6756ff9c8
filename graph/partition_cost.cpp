// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <string>

#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

void check_partition(const Partition& partition, std::size_t expected, const char* what) {
  if (partition.parts == 0) throw InputError("partition", "it has 0 parts", "give at least 1");
  if (partition.part_of.size() != expected)
    throw InputError(
        "partition",
        std::to_string(partition.part_of.size()) + " entries for " + std::to_string(expected) + " " + what,
        "give the partition of these " + std::string(what));
  for (std::size_t i = 0; i < expected; ++i)
    if (partition.part_of[i] >= partition.parts)
      throw InputError("partition",
                       "entry " + std::to_string(i) + " names part " + std::to_string(partition.part_of[i]) +
                           " of " + std::to_string(partition.parts),
                       "number parts from 0");
}

void check_as_many(std::span<const std::uint32_t> weights, std::size_t expected, const char* what) {
  if (weights.empty() || weights.size() == expected) return;
  throw InputError("weights",
                   std::to_string(weights.size()) + " weights for " + std::to_string(expected) + " " + what,
                   "give one each, or none");
}

/// Pieces of each part: components of the graph without its cut edges.
std::vector<std::uint32_t> pieces_per_part(const CsrGraph& graph, const Partition& partition) {
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
                                                                const Partition& partition) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v))
      if (partition.part_of[w] != partition.part_of[v]) pairs.emplace_back(partition.part_of[w], v);
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

Partition vertex_partition_from_dual(const TriangleMesh& mesh, const Partition& triangles) {
  check_partition(triangles, mesh.triangle_count(), "triangles");
  std::vector<std::size_t> start(mesh.vertex_count() + 1, 0);
  for (const auto& corners : mesh.corners)
    for (const VertexId v : corners) {
      if (!mesh.points.contains(v))
        throw InputError("mesh",
                         "a triangle has corner " + std::to_string(v.raw) + " of " +
                             std::to_string(mesh.vertex_count()) + " vertices",
                         "see mesh::validate");
      ++start[v.index() + 1];
    }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> parts_at(start.back());  // per vertex: the parts of its triangles
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (const TriangleId t : mesh.corners.ids())
    for (const VertexId v : mesh.corners[t]) parts_at[next[v.index()]++] = triangles.part_of[t.index()];

  Partition result{triangles.parts, std::vector<std::uint32_t>(mesh.vertex_count(), 0), triangles.outcome};
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto here = std::span(parts_at).subspan(start[v], start[v + 1] - start[v]);
    std::ranges::sort(here);
    std::ptrdiff_t most = 0;
    for (auto run = here.begin(); run != here.end();) {
      const auto end = std::upper_bound(run, here.end(), *run);
      if (end - run > most) {
        most = end - run;
        result.part_of[v] = *run;
      }
      run = end;
    }
  }
  return result;
}

PartitionCost partition_cost(const CsrGraph& graph, const Partition& partition,
                             std::span<const std::uint32_t> vertex_weights,
                             std::span<const std::uint32_t> edge_weights) {
  const std::uint32_t n = vertex_count(graph), parts = partition.parts;
  check_partition(partition, n, "vertices");
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
