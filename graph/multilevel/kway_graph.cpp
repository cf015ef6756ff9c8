// SPDX-License-Identifier: MIT
#include "leonhard/graph/multilevel/kway_graph.hpp"

#include <limits>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph::detail {
namespace {

constexpr std::uint64_t largest_sum = std::numeric_limits<std::int32_t>::max();

void check_weights(std::span<const std::uint32_t> weights, std::size_t expected, const char* name,
                   const char* of) {
  const auto refuse = [&](const std::string& problem, const char* remedy) {
    throw InputError(name, problem, remedy);
  };
  if (weights.size() != expected)
    refuse(std::to_string(weights.size()) + " weights for " + std::to_string(expected) + " " + of,
           "give one each");
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0) refuse("weight " + std::to_string(i) + " is 0", "give positive weights");
    sum += weights[i];
    if (sum > largest_sum) refuse("the weights' sum is 2^31 or more", "scale them down");
  }
}

/// The two directions of an edge must weigh the same.
void check_symmetry(const CsrGraph& graph, const KwayGraph& weighted) {
  const auto offsets = weighted.arcs.offsets();
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  // Rows ascend, so the arcs into w come in the sequence of w's row when v runs upwards.
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const Arc& arc : weighted.row(v)) {
      const Arc& back = weighted.arcs.links()[next[arc.to]++];
      if (back.to != v || back.weight != arc.weight)
        throw InputError("edge_weights",
                         "edge " + std::to_string(v) + "-" + std::to_string(arc.to) + " weighs " +
                             std::to_string(arc.weight) + " one way and " + std::to_string(back.weight) +
                             " the other",
                         "give both directions the same weight");
    }
}

}  // namespace

KwayGraph weighted_graph(const CsrGraph& graph, std::span<const std::uint32_t> vertex_weights,
                         std::span<const std::uint32_t> edge_weights) {
  const std::uint32_t n = vertex_count(graph);
  const std::size_t arcs = 2 * edge_count(graph);
  if (!vertex_weights.empty()) check_weights(vertex_weights, n, "vertex_weights", "vertices");
  if (!edge_weights.empty()) check_weights(edge_weights, arcs, "edge_weights", "directed edges");
  if (n > largest_sum || arcs > largest_sum)
    throw InputError("graph", std::to_string(n) + " vertices and " + std::to_string(arcs / 2) + " edges",
                     "the multilevel method takes fewer than 2^31 vertices and 2^30 edges");
  KwayGraph result;
  result.arcs.reserve(n, arcs);
  for (std::uint32_t v = 0; v < n; ++v) {
    for (const std::uint32_t w : neighbours(graph, v))
      result.arcs.add_link(
          {w, edge_weights.empty() ? 1 : static_cast<std::int32_t>(edge_weights[result.arcs.link_count()])});
    result.arcs.end_row();
  }
  if (vertex_weights.empty())
    result.vertex_weight.assign(n, 1);
  else
    result.vertex_weight.assign(vertex_weights.begin(), vertex_weights.end());
  for (const std::int32_t weight : result.vertex_weight) result.total_weight += weight;
  if (!edge_weights.empty()) check_symmetry(graph, result);
  return result;
}

KwayGraph KwaySubgraph::operator()(std::span<const std::uint32_t> vertices,
                                   std::span<const std::uint32_t> side) {
  KwayGraph result;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) new_of_old_[vertices[i]] = i;
  result.arcs.reserve(vertices.size(), 0);
  result.vertex_weight.reserve(vertices.size());
  for (const std::uint32_t v : vertices) {
    for (const Arc& arc : graph_->row(v))
      if (side[arc.to] == side[v]) result.arcs.add_link({new_of_old_[arc.to], arc.weight});
    result.arcs.end_row();
    result.vertex_weight.push_back(graph_->vertex_weight[v]);
    result.total_weight += graph_->vertex_weight[v];
  }
  return result;
}

KwayComponents components(const KwayGraph& graph) {
  constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
  KwayComponents result{std::vector<std::uint32_t>(graph.size(), unknown), 0};
  std::vector<std::uint32_t> stack;
  for (std::uint32_t root = 0; root < graph.size(); ++root) {
    if (result.component_of[root] != unknown) continue;
    result.component_of[root] = result.count;
    stack.push_back(root);
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      for (const Arc& arc : graph.row(v))
        if (result.component_of[arc.to] == unknown) {
          result.component_of[arc.to] = result.count;
          stack.push_back(arc.to);
        }
    }
    ++result.count;
  }
  return result;
}

std::int64_t cut_of(const KwayGraph& graph, std::span<const std::uint32_t> part_of) {
  std::int64_t twice = 0;
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    for (const Arc& arc : graph.row(v)) twice += part_of[v] != part_of[arc.to] ? arc.weight : 0;
  return twice / 2;
}

std::vector<std::int64_t> part_weights(const KwayGraph& graph, std::span<const std::uint32_t> part_of,
                                       std::uint32_t parts) {
  std::vector<std::int64_t> weights(parts, 0);
  for (std::uint32_t v = 0; v < graph.size(); ++v) weights[part_of[v]] += graph.vertex_weight[v];
  return weights;
}

}  // namespace leonhard::graph::detail
