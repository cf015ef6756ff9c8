// SPDX-License-Identifier: MIT
// Boost.Graph's ordering behind this room's conventions.
#if defined(__GNUC__) && !defined(__clang__)  // the visitor is copied before its first event sets a member
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/graph/king_ordering.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
#include <iterator>

#include "leonhard/graph/by_component.hpp"
#include "leonhard/graph/level_search.hpp"
#include "leonhard/graph/ordering.hpp"

namespace leonhard::graph {
namespace {

template <class T>
auto by_vertex(const CsrGraph& graph, std::vector<T>& values) {
  return boost::make_iterator_property_map(values.begin(), boost::get(boost::vertex_index, graph));
}

std::vector<std::uint32_t> degrees(const CsrGraph& graph) {
  std::vector<std::uint32_t> result(vertex_count(graph));
  for (std::uint32_t v = 0; v < result.size(); ++v) result[v] = degree(graph, v);
  return result;
}

std::vector<std::uint32_t> king_connected(const CsrGraph& graph) {
  detail::LevelSearch search(graph);
  const std::uint32_t root =
      detail::pseudo_peripheral(graph, search, detail::vertices_by_degree(graph).front());
  std::vector<std::uint32_t> order, degree_of = degrees(graph);
  std::vector<boost::default_color_type> colour(vertex_count(graph));
  boost::king_ordering(graph, root, std::back_inserter(order), by_vertex(graph, colour),
                       by_vertex(graph, degree_of), boost::get(boost::vertex_index, graph));
  return detail::better_direction(graph, std::move(order));
}

}  // namespace

std::vector<std::uint32_t> king(const CsrGraph& graph) {
  return detail::order_by_component(
      graph, [](const CsrGraph& connected, const auto&) { return king_connected(connected); });
}

}  // namespace leonhard::graph
