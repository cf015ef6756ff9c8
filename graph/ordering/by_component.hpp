// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/support/step_counter.hpp"

namespace leonhard::graph::detail {

/// Orders a graph component by component, by a method for connected graphs of at least two vertices. The components
/// follow one another by smallest vertex.
///
/// order_connected  (const CsrGraph& connected, const std::vector<std::uint32_t>& its vertices' names) -> order
template <class OrderConnected>
std::vector<std::uint32_t> order_by_component(const CsrGraph& graph, const OrderConnected& order_connected) {
  const Components parts = components(graph);
  std::vector<std::vector<std::uint32_t>> members(parts.count());
  for (std::uint32_t c = 0; c < parts.count(); ++c) members[c].reserve(parts.sizes[c]);
  for (std::uint32_t v = 0; v < parts.component_of.size(); ++v) members[parts.component_of[v]].push_back(v);
  std::vector<std::uint32_t> order;
  order.reserve(vertex_count(graph));
  SubgraphExtractor extract(graph);
  for (const std::vector<std::uint32_t>& vertices : members) {
    if (vertices.size() == 1) {
      order.push_back(vertices.front());
      continue;
    }
    const bool whole = vertices.size() == vertex_count(graph);
    for (const std::uint32_t v : order_connected(whole ? graph : extract(vertices), vertices))
      order.push_back(vertices[v]);
  }
  return order;
}

/// The same with a stop: what a method leaves out of an order follows by index.
///
/// order_connected  (const CsrGraph& connected, StepCounter& steps) -> order, cut short if steps was stopped
template <class OrderConnected>
OrderResult order_by_component(const CsrGraph& graph, StepCounter& steps,
                               const OrderConnected& order_connected) {
  OrderResult result;
  result.order = order_by_component(graph, [&](const CsrGraph& connected, const auto&) {
    std::vector<std::uint32_t> order;
    if (steps.goes_on()) order = order_connected(connected, steps);
    append_missing(order, natural_order(connected));
    return order;
  });
  if (steps.stopped()) result.outcome = OrderOutcome::stopped;
  return result;
}

}  // namespace leonhard::graph::detail
