// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/kway_balance.hpp"

#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

#include "leonhard/graph/partition/kway_fm.hpp"

namespace leonhard::graph::detail {
namespace {

/// Each vertex, the heaviest first, to the lightest part.
std::vector<std::uint32_t> heaviest_to_lightest(const KwayGraph& graph, std::uint32_t parts) {
  std::vector<std::uint32_t> order(graph.size()), part_of(graph.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::uint32_t v) { return graph.vertex_weight[v]; });
  using Load = std::pair<std::int64_t, std::uint32_t>;  // weight, part
  std::priority_queue<Load, std::vector<Load>, std::greater<>> lightest;
  for (std::uint32_t p = 0; p < parts; ++p) lightest.emplace(0, p);
  for (const std::uint32_t v : order) {
    const auto [weight, part] = lightest.top();
    lightest.pop();
    part_of[v] = part;
    lightest.emplace(weight + graph.vertex_weight[v], part);
  }
  return part_of;
}

/// Gives every empty part the vertex of a part of several whose leaving costs the cut least.
void fill_empty_parts(const KwayGraph& graph, std::uint32_t parts, std::vector<std::uint32_t>& part_of) {
  std::vector<std::uint32_t> size(parts, 0);
  for (const std::uint32_t part : part_of) ++size[part];
  for (std::uint32_t empty = 0; empty < parts; ++empty) {
    if (size[empty] > 0) continue;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::uint32_t chosen = graph.size();
    for (std::uint32_t v = 0; v < graph.size(); ++v) {
      if (size[part_of[v]] < 2) continue;
      std::int64_t loss = 0;
      for (const Arc& arc : graph.row(v)) loss += part_of[arc.to] == part_of[v] ? arc.weight : 0;
      if (loss >= least) continue;
      least = loss;
      chosen = v;
    }
    if (chosen == graph.size()) return;  // fewer vertices than parts
    --size[part_of[chosen]];
    part_of[chosen] = empty;
    ++size[empty];
  }
}

bool keeps(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
           std::span<const std::uint32_t> part_of) {
  return std::ranges::max(part_weights(graph, part_of, parts)) <= limit;
}

}  // namespace

bool keep_limit(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
                std::vector<std::uint32_t>& part_of) {
  fill_empty_parts(graph, parts, part_of);
  if (keeps(graph, parts, limit, part_of)) return true;
  Random random(1);
  std::vector<std::uint32_t> moved = part_of;
  if (KwayFm(graph, parts, limit, moved, random).rebalance()) {
    part_of = std::move(moved);
    fill_empty_parts(graph, parts, part_of);
    return true;
  }
  std::vector<std::uint32_t> dealt = heaviest_to_lightest(graph, parts);
  if (keeps(graph, parts, limit, dealt)) {
    part_of = std::move(dealt);
    return true;
  }
  return false;
}

}  // namespace leonhard::graph::detail
