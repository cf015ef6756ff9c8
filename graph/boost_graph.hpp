// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "leonhard/graph/colouring.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/order.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"

/// CsrGraph as a graph of Boost.Graph, without a copy: whoever includes this header can hand one to Boost.Graph's
/// algorithms as it is. It is a model of VertexListGraph, IncidenceGraph, AdjacencyGraph and EdgeListGraph.
///
/// To Boost.Graph the graph is directed: every edge is two arcs, one each way. Arcs are numbered row by row, from 0 to
/// 2 edge_count(graph) - 1, so the index of an arc is its place in graph.rows().links(); the arcs of vertex v begin at
/// graph.rows().offsets()[v]. Algorithms that must meet an edge once take an UndirectedGraph (below).
///
/// Property maps: vertex_index (the vertex itself) and edge_index (an arc's index). What is kept in a vector, one an arc,
/// becomes a property map by boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, graph)).
///
/// The other way, graph_from(), order(), partition() and colour_vertices() below take Boost.Graph's graphs.
namespace leonhard::graph {

/// One direction of an edge: Boost.Graph's edge descriptor.
struct BoostArc {
  std::uint32_t from{};
  std::uint32_t index{};  ///< among all arcs

  friend bool operator==(const BoostArc&, const BoostArc&) = default;
};

/// The arcs of one vertex, one after another.
class BoostOutArcIterator
    : public boost::iterator_facade<BoostOutArcIterator, BoostArc, boost::random_access_traversal_tag,
                                    BoostArc, std::ptrdiff_t> {
 public:
  BoostOutArcIterator() = default;
  explicit BoostOutArcIterator(BoostArc arc) : arc_(arc) {}

 private:
  friend class boost::iterator_core_access;
  [[nodiscard]] BoostArc dereference() const { return arc_; }
  [[nodiscard]] bool equal(const BoostOutArcIterator& other) const { return arc_.index == other.arc_.index; }
  void increment() { ++arc_.index; }
  void decrement() { --arc_.index; }
  void advance(std::ptrdiff_t n) { arc_.index = static_cast<std::uint32_t>(arc_.index + n); }
  [[nodiscard]] std::ptrdiff_t distance_to(const BoostOutArcIterator& other) const {
    return std::ptrdiff_t{other.arc_.index} - std::ptrdiff_t{arc_.index};
  }

  BoostArc arc_;
};

/// All arcs, row by row.
class BoostArcIterator
    : public boost::iterator_facade<BoostArcIterator, BoostArc, boost::forward_traversal_tag, BoostArc,
                                    std::ptrdiff_t> {
 public:
  BoostArcIterator() = default;
  BoostArcIterator(const CsrGraph& graph, BoostArc arc) : graph_(&graph), arc_(arc) { find_row(); }

 private:
  friend class boost::iterator_core_access;
  [[nodiscard]] BoostArc dereference() const { return arc_; }
  [[nodiscard]] bool equal(const BoostArcIterator& other) const { return arc_.index == other.arc_.index; }
  void increment() {
    ++arc_.index;
    find_row();
  }
  void find_row() {
    const auto offsets = graph_->rows().offsets();
    while (arc_.from + std::size_t{1} < offsets.size() && offsets[arc_.from + std::size_t{1}] <= arc_.index)
      ++arc_.from;
  }

  const CsrGraph* graph_ = nullptr;
  BoostArc arc_;
};

/// From an arc to its index.
struct BoostArcIndexMap {
  using key_type = BoostArc;
  using value_type = std::uint32_t;
  using reference = std::uint32_t;
  using category = boost::readable_property_map_tag;

  std::uint32_t operator[](const BoostArc& arc) const { return arc.index; }
  friend std::uint32_t get(const BoostArcIndexMap&, const BoostArc& arc) { return arc.index; }
};

struct BoostTraversalCategory : virtual boost::vertex_list_graph_tag,
                                virtual boost::incidence_graph_tag,
                                virtual boost::adjacency_graph_tag,
                                virtual boost::edge_list_graph_tag {};

}  // namespace leonhard::graph

template <>
struct boost::graph_traits<leonhard::graph::CsrGraph> {
  using vertex_descriptor = std::uint32_t;
  using edge_descriptor = leonhard::graph::BoostArc;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = leonhard::graph::BoostTraversalCategory;
  using vertex_iterator = boost::counting_iterator<std::uint32_t>;
  using adjacency_iterator = const std::uint32_t*;
  using out_edge_iterator = leonhard::graph::BoostOutArcIterator;
  using in_edge_iterator = void;
  using edge_iterator = leonhard::graph::BoostArcIterator;
  using vertices_size_type = std::uint32_t;
  using edges_size_type = std::uint32_t;
  using degree_size_type = std::uint32_t;
  static vertex_descriptor null_vertex() { return static_cast<std::uint32_t>(-1); }
};

template <>
struct boost::graph_traits<const leonhard::graph::CsrGraph> : boost::graph_traits<leonhard::graph::CsrGraph> {};

template <>
struct boost::property_map<leonhard::graph::CsrGraph, boost::vertex_index_t> {
  using type = boost::typed_identity_property_map<std::uint32_t>;
  using const_type = type;
};
template <>
struct boost::property_map<leonhard::graph::CsrGraph, boost::edge_index_t> {
  using type = leonhard::graph::BoostArcIndexMap;
  using const_type = type;
};
template <class Property>
struct boost::property_map<const leonhard::graph::CsrGraph, Property>
    : boost::property_map<leonhard::graph::CsrGraph, Property> {};

namespace leonhard::graph {

// What Boost.Graph's concepts ask for, found by the type of the graph.

[[nodiscard]] inline std::uint32_t num_vertices(const CsrGraph& graph) { return vertex_count(graph); }
[[nodiscard]] inline auto vertices(const CsrGraph& graph) {
  return std::pair(boost::counting_iterator<std::uint32_t>(0),
                   boost::counting_iterator<std::uint32_t>(vertex_count(graph)));
}

/// Arcs: twice edge_count(graph).
[[nodiscard]] inline std::uint32_t num_edges(const CsrGraph& graph) {
  return static_cast<std::uint32_t>(graph.rows().link_count());
}
[[nodiscard]] inline auto edges(const CsrGraph& graph) {
  return std::pair(BoostArcIterator(graph, {0, 0}),
                   BoostArcIterator(graph, {vertex_count(graph), num_edges(graph)}));
}
[[nodiscard]] inline std::uint32_t source(const BoostArc& arc, const CsrGraph&) { return arc.from; }
[[nodiscard]] inline std::uint32_t target(const BoostArc& arc, const CsrGraph& graph) {
  return graph.rows().links()[arc.index];
}

[[nodiscard]] inline auto out_edges(std::uint32_t v, const CsrGraph& graph) {
  const auto offsets = graph.rows().offsets();
  return std::pair(BoostOutArcIterator({v, offsets[v]}),
                   BoostOutArcIterator({v, offsets[v + std::size_t{1}]}));
}
[[nodiscard]] inline std::uint32_t out_degree(std::uint32_t v, const CsrGraph& graph) {
  return degree(graph, v);
}
[[nodiscard]] inline auto adjacent_vertices(std::uint32_t v, const CsrGraph& graph) {
  const auto row = neighbours(graph, v);
  return std::pair(row.data(), row.data() + row.size());
}

[[nodiscard]] inline boost::typed_identity_property_map<std::uint32_t> get(boost::vertex_index_t,
                                                                           const CsrGraph&) {
  return {};
}
[[nodiscard]] inline std::uint32_t get(boost::vertex_index_t, const CsrGraph&, std::uint32_t v) { return v; }
[[nodiscard]] inline BoostArcIndexMap get(boost::edge_index_t, const CsrGraph&) { return {}; }
[[nodiscard]] inline std::uint32_t get(boost::edge_index_t, const CsrGraph&, const BoostArc& arc) {
  return arc.index;
}

}  // namespace leonhard::graph
