// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "leonhard/graph/boost_graph.hpp"
#include "leonhard/graph/colouring.hpp"
#include "leonhard/graph/order.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"

/// Graphs of Boost.Graph's, whatever their type, for the orderings, partitions and colourings of this library.
namespace leonhard::graph {

/// A graph of Boost.Graph's (adjacency_list, adjacency_matrix, grid_graph, one of the user's own): a VertexListGraph that
/// is an EdgeListGraph or an IncidenceGraph.
template <class Graph>
concept BoostModel = !std::same_as<Graph, CsrGraph> && requires(const Graph& graph) {
  typename boost::graph_traits<Graph>::vertex_descriptor;
  typename boost::graph_traits<Graph>::directed_category;
  num_vertices(graph);
  vertices(graph);
};

namespace detail {

/// One number a vertex, each of 0 .. n - 1 once.
template <class Graph, class VertexIndex>
void check_vertex_index(const Graph& graph, std::size_t count, const VertexIndex& index) {
  std::vector<char> seen(count, 0);
  const auto [first, last] = vertices(graph);
  for (auto v = first; v != last; ++v) {
    const auto number = static_cast<std::uint64_t>(get(index, *v));
    if (number >= count || seen[number] != 0)
      throw InputError("vertex_index",
                       "it gives " + std::to_string(number) +
                           (number >= count ? ", the graph has " : " twice, of ") + std::to_string(count) +
                           " vertices",
                       "number the vertices from 0, each once");
    seen[number] = 1;
  }
}

/// Source and target of all edges, as the graph lists them.
template <class Graph, class VertexIndex>
std::vector<std::array<std::uint32_t, 2>> numbered_edges(const Graph& graph, const VertexIndex& index) {
  std::vector<std::array<std::uint32_t, 2>> list;
  const auto add = [&](const auto& first, const auto& last) {
    for (auto e = first; e != last; ++e)
      list.push_back({static_cast<std::uint32_t>(get(index, source(*e, graph))),
                      static_cast<std::uint32_t>(get(index, target(*e, graph)))});
  };
  if constexpr (requires { edges(graph); }) {
    const auto [first, last] = edges(graph);
    add(first, last);
  } else {
    const auto [first, last] = vertices(graph);
    for (auto v = first; v != last; ++v) {
      const auto [out, out_end] = out_edges(*v, graph);
      add(out, out_end);
    }
  }
  return list;
}

}  // namespace detail

/// A graph of Boost.Graph's as a CsrGraph, with self-loops and parallel edges dropped and counted; properties are not
/// looked at.
///
/// model   undirected, or directed with every edge in both directions
/// index   a property map from vertices to their numbers in the result, 0 .. n - 1; without it the graph's own
///         vertex_index
/// throws  InputError if the index is no such numbering, a directed graph lacks an edge's other direction, or the graph
///         is too large (see graph_from_edges)
/// Cost O(n + m log d), d the largest degree.
template <BoostModel Graph, class VertexIndex>
[[nodiscard]] EdgeListGraph graph_from(const Graph& model, const VertexIndex& index) {
  const auto count = static_cast<std::size_t>(num_vertices(model));
  if (count >= std::numeric_limits<std::uint32_t>::max())
    throw InputError("graph", std::to_string(count) + " vertices", "graphs hold fewer than 2^32 - 1");
  detail::check_vertex_index(model, count, index);
  const auto list = detail::numbered_edges(model, index);
  constexpr bool listed_once =
      std::is_convertible_v<typename boost::graph_traits<Graph>::directed_category, boost::undirected_tag> &&
      requires {
    edges(model);
  };
  const auto vertices = static_cast<std::uint32_t>(count);
  return listed_once ? graph_from_edges(vertices, list) : graph_from_arcs(vertices, list);
}

template <BoostModel Graph>
[[nodiscard]] EdgeListGraph graph_from(const Graph& model) {
  return graph_from(model, get(boost::vertex_index, model));
}

/// order() of a graph of Boost.Graph's: order[new] = old vertex_index. Throws and costs as graph_from() and order() do.
template <BoostModel Graph>
OrderResult order(const Graph& model, const OrderOptions& options = {}) {
  return order(graph_from(model).graph, options);
}

/// partition() of a graph of Boost.Graph's, by vertex_index. Weights of edges are in the sequence of graph_from(model).
template <BoostModel Graph>
Partition partition(const Graph& model, std::uint32_t parts, const PartitionOptions& options = {}) {
  return partition(graph_from(model).graph, parts, options);
}

/// colour_vertices() of a graph of Boost.Graph's, by vertex_index.
template <BoostModel Graph>
[[nodiscard]] Colouring colour_vertices(const Graph& model) {
  return colour_vertices(graph_from(model).graph);
}

}  // namespace leonhard::graph
