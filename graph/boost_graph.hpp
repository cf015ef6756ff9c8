// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"

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
/// The other way, boost_models.hpp takes Boost.Graph's graphs into this library.
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
struct boost::graph_traits<const leonhard::graph::CsrGraph> : boost::graph_traits<leonhard::graph::CsrGraph> {
};

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

/// king_ordering asks for it by this name.
[[nodiscard]] inline bool has_no_vertices(const CsrGraph& graph) { return vertex_count(graph) == 0; }

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

/// The arc between two vertices, and whether there is one. Cost O(log degree).
[[nodiscard]] inline std::pair<BoostArc, bool> edge(std::uint32_t from, std::uint32_t to,
                                                    const CsrGraph& graph) {
  const auto row = neighbours(graph, from);
  const auto found = std::ranges::lower_bound(row, to);
  const auto place = static_cast<std::uint32_t>(found - row.begin());
  return {{from, graph.rows().offsets()[from] + place}, found != row.end() && *found == to};
}

/// An edge as one of its ends sees it: the edge descriptor of UndirectedGraph.
struct BoostEdge {
  std::uint32_t from{}, to{};
  std::uint32_t index{};  ///< among all edges, as edges_of() lists them

  friend bool operator==(const BoostEdge& a, const BoostEdge& b) { return a.index == b.index; }
};

/// The same graph, undirected to Boost.Graph: an edge is the same edge from whichever end it is met. Edges are numbered
/// as edges_of() and a mesh's EdgeStructure number them. For the algorithms that need that, such as edge_coloring,
/// boyer_myrvold_planarity_test, kruskal_minimum_spanning_tree, biconnected_components and the matchings. A model of
/// VertexListGraph, BidirectionalGraph, AdjacencyGraph and EdgeListGraph.
class UndirectedGraph {
 public:
  /// graph  must outlive this
  /// Cost O(m log d), and memory of one number an arc; the graph itself is not copied.
  explicit UndirectedGraph(const CsrGraph& graph) : graph_(&graph), edge_of_(graph.rows().link_count()) {
    std::uint32_t next = 0;
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
      for (std::uint32_t arc = first_arc(v); arc < first_arc(v + 1); ++arc) {
        const std::uint32_t w = head_of(arc);
        edge_of_[arc] = v < w ? next++ : edge_of_[leonhard::graph::edge(w, v, graph).first.index];
      }
  }

  [[nodiscard]] const CsrGraph& directed() const { return *graph_; }
  /// The arcs of v are first_arc(v) .. first_arc(v + 1) - 1.
  [[nodiscard]] std::uint32_t first_arc(std::uint32_t v) const { return graph_->rows().offsets()[v]; }
  [[nodiscard]] std::uint32_t head_of(std::uint32_t arc) const { return graph_->rows().links()[arc]; }
  [[nodiscard]] std::uint32_t edge_of(std::uint32_t arc) const { return edge_of_[arc]; }

 private:
  const CsrGraph* graph_;
  std::vector<std::uint32_t> edge_of_;  ///< per arc
};

enum class BoostEnd { source, target };

/// The edges of one vertex, which is their source or their target.
template <BoostEnd end>
class BoostEndIterator
    : public boost::iterator_facade<BoostEndIterator<end>, BoostEdge, boost::random_access_traversal_tag,
                                    BoostEdge, std::ptrdiff_t> {
 public:
  BoostEndIterator() = default;
  BoostEndIterator(const UndirectedGraph& graph, std::uint32_t vertex, std::uint32_t arc)
      : graph_(&graph), vertex_(vertex), arc_(arc) {}

 private:
  friend class boost::iterator_core_access;
  [[nodiscard]] BoostEdge dereference() const {
    const std::uint32_t other = graph_->head_of(arc_), index = graph_->edge_of(arc_);
    return end == BoostEnd::source ? BoostEdge{vertex_, other, index} : BoostEdge{other, vertex_, index};
  }
  [[nodiscard]] bool equal(const BoostEndIterator& other) const { return arc_ == other.arc_; }
  void increment() { ++arc_; }
  void decrement() { --arc_; }
  void advance(std::ptrdiff_t n) { arc_ = static_cast<std::uint32_t>(arc_ + n); }
  [[nodiscard]] std::ptrdiff_t distance_to(const BoostEndIterator& other) const {
    return std::ptrdiff_t{other.arc_} - std::ptrdiff_t{arc_};
  }

  const UndirectedGraph* graph_ = nullptr;
  std::uint32_t vertex_{}, arc_{};
};

/// All edges, each once, from the smaller end.
class BoostEdgeIterator
    : public boost::iterator_facade<BoostEdgeIterator, BoostEdge, boost::forward_traversal_tag, BoostEdge,
                                    std::ptrdiff_t> {
 public:
  BoostEdgeIterator() = default;
  BoostEdgeIterator(const UndirectedGraph& graph, BoostArcIterator arc, BoostArcIterator end)
      : graph_(&graph), arc_(arc), end_(end) {
    skip();
  }

 private:
  friend class boost::iterator_core_access;
  [[nodiscard]] BoostEdge dereference() const {
    return {arc_->from, graph_->head_of(arc_->index), graph_->edge_of(arc_->index)};
  }
  [[nodiscard]] bool equal(const BoostEdgeIterator& other) const { return arc_ == other.arc_; }
  void increment() {
    ++arc_;
    skip();
  }
  void skip() {
    while (arc_ != end_ && arc_->from > graph_->head_of(arc_->index)) ++arc_;
  }

  const UndirectedGraph* graph_ = nullptr;
  BoostArcIterator arc_, end_;
};

/// From an edge to its index.
struct BoostEdgeIndexMap {
  using key_type = BoostEdge;
  using value_type = std::uint32_t;
  using reference = std::uint32_t;
  using category = boost::readable_property_map_tag;

  std::uint32_t operator[](const BoostEdge& edge) const { return edge.index; }
  friend std::uint32_t get(const BoostEdgeIndexMap&, const BoostEdge& edge) { return edge.index; }
};

struct BoostUndirectedTraversalCategory : virtual boost::vertex_list_graph_tag,
                                          virtual boost::bidirectional_graph_tag,
                                          virtual boost::adjacency_graph_tag,
                                          virtual boost::edge_list_graph_tag {};

}  // namespace leonhard::graph

template <>
struct boost::graph_traits<leonhard::graph::UndirectedGraph>
    : boost::graph_traits<leonhard::graph::CsrGraph> {
  using edge_descriptor = leonhard::graph::BoostEdge;
  using directed_category = boost::undirected_tag;
  using traversal_category = leonhard::graph::BoostUndirectedTraversalCategory;
  using out_edge_iterator = leonhard::graph::BoostEndIterator<leonhard::graph::BoostEnd::source>;
  using in_edge_iterator = leonhard::graph::BoostEndIterator<leonhard::graph::BoostEnd::target>;
  using edge_iterator = leonhard::graph::BoostEdgeIterator;
};
template <>
struct boost::graph_traits<const leonhard::graph::UndirectedGraph>
    : boost::graph_traits<leonhard::graph::UndirectedGraph> {};

template <>
struct boost::property_map<leonhard::graph::UndirectedGraph, boost::vertex_index_t> {
  using type = boost::typed_identity_property_map<std::uint32_t>;
  using const_type = type;
};
template <>
struct boost::property_map<leonhard::graph::UndirectedGraph, boost::edge_index_t> {
  using type = leonhard::graph::BoostEdgeIndexMap;
  using const_type = type;
};
template <class Property>
struct boost::property_map<const leonhard::graph::UndirectedGraph, Property>
    : boost::property_map<leonhard::graph::UndirectedGraph, Property> {};

namespace leonhard::graph {

[[nodiscard]] inline std::uint32_t num_vertices(const UndirectedGraph& graph) {
  return vertex_count(graph.directed());
}
[[nodiscard]] inline auto vertices(const UndirectedGraph& graph) { return vertices(graph.directed()); }

[[nodiscard]] inline bool has_no_vertices(const UndirectedGraph& graph) { return num_vertices(graph) == 0; }

[[nodiscard]] inline std::uint32_t num_edges(const UndirectedGraph& graph) {
  return static_cast<std::uint32_t>(edge_count(graph.directed()));
}
[[nodiscard]] inline auto edges(const UndirectedGraph& graph) {
  const auto [first, last] = edges(graph.directed());
  return std::pair(BoostEdgeIterator(graph, first, last), BoostEdgeIterator(graph, last, last));
}
[[nodiscard]] inline std::uint32_t source(const BoostEdge& edge, const UndirectedGraph&) { return edge.from; }
[[nodiscard]] inline std::uint32_t target(const BoostEdge& edge, const UndirectedGraph&) { return edge.to; }

[[nodiscard]] inline auto out_edges(std::uint32_t v, const UndirectedGraph& graph) {
  using Iterator = BoostEndIterator<BoostEnd::source>;
  return std::pair(Iterator(graph, v, graph.first_arc(v)), Iterator(graph, v, graph.first_arc(v + 1)));
}
[[nodiscard]] inline auto in_edges(std::uint32_t v, const UndirectedGraph& graph) {
  using Iterator = BoostEndIterator<BoostEnd::target>;
  return std::pair(Iterator(graph, v, graph.first_arc(v)), Iterator(graph, v, graph.first_arc(v + 1)));
}
[[nodiscard]] inline std::uint32_t out_degree(std::uint32_t v, const UndirectedGraph& graph) {
  return degree(graph.directed(), v);
}
[[nodiscard]] inline std::uint32_t in_degree(std::uint32_t v, const UndirectedGraph& graph) {
  return degree(graph.directed(), v);
}
[[nodiscard]] inline std::uint32_t degree(std::uint32_t v, const UndirectedGraph& graph) {
  return degree(graph.directed(), v);
}
[[nodiscard]] inline auto adjacent_vertices(std::uint32_t v, const UndirectedGraph& graph) {
  return adjacent_vertices(v, graph.directed());
}
[[nodiscard]] inline std::pair<BoostEdge, bool> edge(std::uint32_t from, std::uint32_t to,
                                                     const UndirectedGraph& graph) {
  const auto [arc, exists] = edge(from, to, graph.directed());
  return {exists ? BoostEdge{from, to, graph.edge_of(arc.index)} : BoostEdge{}, exists};
}

[[nodiscard]] inline boost::typed_identity_property_map<std::uint32_t> get(boost::vertex_index_t,
                                                                           const UndirectedGraph&) {
  return {};
}
[[nodiscard]] inline std::uint32_t get(boost::vertex_index_t, const UndirectedGraph&, std::uint32_t v) {
  return v;
}
[[nodiscard]] inline BoostEdgeIndexMap get(boost::edge_index_t, const UndirectedGraph&) { return {}; }
[[nodiscard]] inline std::uint32_t get(boost::edge_index_t, const UndirectedGraph&, const BoostEdge& edge) {
  return edge.index;
}

}  // namespace leonhard::graph
