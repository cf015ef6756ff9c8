// SPDX-License-Identifier: MIT
#include "leonhard/graph/boost_graph.hpp"

#include <doctest/doctest.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/adjacency_matrix.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/edge_coloring.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/king_ordering.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/graph/sequential_vertex_coloring.hpp>
#include <boost/graph/sloan_ordering.hpp>
#include <queue>

#include "leonhard/graph/boost_models.hpp"
#include "leonhard/graph/fill.hpp"
#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/orientation.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<CsrGraph>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<CsrGraph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<CsrGraph>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<CsrGraph>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<CsrGraph, std::uint32_t, boost::vertex_index_t>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<CsrGraph, BoostArc, boost::edge_index_t>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<UndirectedGraph>));
BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<UndirectedGraph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<UndirectedGraph>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<UndirectedGraph>));
BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<UndirectedGraph, BoostEdge, boost::edge_index_t>));

namespace {

using Undirected = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
using Directed = boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS>;

std::vector<CsrGraph> boost_shelf() {
  return {graph_from_edges(0, {}).graph,
          graph_from_edges(4, {}).graph,
          path(7),
          cycle(8),
          complete(6),
          star(9),
          wheel(8),
          random_graph(20, 60, 3),
          random_mesh_graph(7, 5, 2),
          disjoint_union({grid(4, 5), path(1), cycle(5), path(1)})};
}

Undirected boost_copy(const CsrGraph& graph) {
  Undirected copy(vertex_count(graph));
  for (const auto& [a, b] : edges_of(graph)) add_edge(a, b, copy);
  return copy;
}

/// Distances in edges by a queue of our own.
std::vector<std::uint32_t> levels_by_queue(const CsrGraph& graph, std::uint32_t root) {
  std::vector<std::uint32_t> level(vertex_count(graph), ~0U);
  std::queue<std::uint32_t> queue({root});
  level[root] = 0;
  for (; !queue.empty(); queue.pop())
    for (const std::uint32_t w : neighbours(graph, queue.front()))
      if (level[w] == ~0U) {
        level[w] = level[queue.front()] + 1;
        queue.push(w);
      }
  return level;
}

/// Lengths of shortest paths by relaxing all arcs until nothing changes (Bellman and Ford).
std::vector<double> distances_from(const CsrGraph& graph, std::uint32_t root,
                                   const std::vector<double>& length) {
  std::vector<double> distance(vertex_count(graph), std::numeric_limits<double>::max());
  distance[root] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    std::size_t arc = 0;
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
      for (const std::uint32_t w : neighbours(graph, v)) {
        const double found = distance[v] + length[arc++];
        if (distance[v] < std::numeric_limits<double>::max() && found < distance[w]) {
          distance[w] = found;
          changed = true;
        }
      }
  }
  return distance;
}

}  // namespace

TEST_CASE("boost_walks_the_vertices_arcs_and_edges_of_a_graph") {
  for (const CsrGraph& graph : boost_shelf()) {
    REQUIRE(num_vertices(graph) == vertex_count(graph));
    REQUIRE(num_edges(graph) == 2 * edge_count(graph));
    std::uint32_t next = 0;
    const auto [first, last] = edges(graph);
    for (auto e = first; e != last; ++e, ++next) {
      CHECK(get(boost::edge_index, graph, *e) == next);
      const auto row = neighbours(graph, source(*e, graph));
      CHECK(std::ranges::binary_search(row, target(*e, graph)));
      CHECK(edge(source(*e, graph), target(*e, graph), graph) == std::pair(*e, true));
    }
    CHECK(next == num_edges(graph));

    const UndirectedGraph undirected(graph);
    const auto list = edges_of(graph);
    REQUIRE(num_edges(undirected) == list.size());
    next = 0;
    const auto [begin, end] = edges(undirected);
    for (auto e = begin; e != end; ++e, ++next) {
      CHECK(std::array{source(*e, undirected), target(*e, undirected)} == list[next]);
      CHECK(get(boost::edge_index, undirected, *e) == next);
      const auto [back, exists] = edge(list[next][1], list[next][0], undirected);
      CHECK(exists);
      CHECK(back == *e);
    }
    CHECK(next == list.size());
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v) {
      std::vector<std::uint32_t> out, in;
      const auto [o, o_end] = out_edges(v, undirected);
      for (auto e = o; e != o_end; ++e) {
        CHECK(source(*e, undirected) == v);
        out.push_back(target(*e, undirected));
      }
      const auto [i, i_end] = in_edges(v, undirected);
      for (auto e = i; e != i_end; ++e) {
        CHECK(target(*e, undirected) == v);
        in.push_back(source(*e, undirected));
      }
      CHECK(std::ranges::equal(out, neighbours(graph, v)));
      CHECK(in == out);
    }
  }
}

TEST_CASE("edge_says_where_there_is_none") {
  const CsrGraph graph = path(3);
  CHECK_FALSE(edge(0, 2, graph).second);
  CHECK_FALSE(edge(2, 0, UndirectedGraph(graph)).second);
}

TEST_CASE("boost_searches_breadth_first_as_a_queue_does") {
  for (const CsrGraph& graph : boost_shelf()) {
    if (vertex_count(graph) == 0) continue;
    std::vector<std::uint32_t> level(vertex_count(graph), ~0U);
    level[0] = 0;
    const auto levels = boost::make_iterator_property_map(level.begin(), get(boost::vertex_index, graph));
    boost::breadth_first_search(
        graph, 0U,
        boost::visitor(boost::make_bfs_visitor(boost::record_distances(levels, boost::on_tree_edge()))));
    CHECK(level == levels_by_queue(graph, 0));
  }
}

TEST_CASE("boost_finds_shortest_paths_along_weighted_arcs") {
  std::mt19937_64 random(5);
  for (const CsrGraph& graph : boost_shelf()) {
    if (vertex_count(graph) == 0) continue;
    std::vector<double> length(num_edges(graph));
    for (double& l : length) l = static_cast<double>(1 + random() % 100);
    std::vector<double> distance(vertex_count(graph));
    boost::dijkstra_shortest_paths(
        graph, 0U,
        boost::weight_map(boost::make_iterator_property_map(length.begin(), get(boost::edge_index, graph)))
            .distance_map(
                boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, graph))));
    CHECK(distance == distances_from(graph, 0, length));
  }
}

TEST_CASE("boost_counts_components_of_either_view") {
  for (const CsrGraph& graph : boost_shelf()) {
    const Components ours = components(graph);
    const UndirectedGraph undirected(graph);
    std::vector<std::uint32_t> theirs(vertex_count(graph)), of_edges(vertex_count(graph));
    CHECK(boost::connected_components(graph, theirs.data()) == ours.count());
    CHECK(theirs == ours.component_of);
    CHECK(boost::connected_components(undirected, of_edges.data()) == ours.count());
    CHECK(of_edges == ours.component_of);
  }
}

TEST_CASE("boost_tests_planarity_without_a_copy_as_with_one") {
  for (const CsrGraph& graph : boost_shelf()) {
    const UndirectedGraph undirected(graph);
    CHECK(boost::boyer_myrvold_planarity_test(undirected) ==
          boost::boyer_myrvold_planarity_test(boost_copy(graph)));
    CHECK(is_planar(graph) == boost::boyer_myrvold_planarity_test(boost_copy(graph)));
  }
  CHECK_FALSE(is_planar(complete(5)));
  CHECK(is_planar(complete(4)));
}

TEST_CASE("boost_colours_vertices_and_edges") {
  for (const CsrGraph& graph : boost_shelf()) {
    const std::uint32_t n = vertex_count(graph);
    Colouring vertices{0, std::vector<std::uint32_t>(n)};
    vertices.colours = boost::sequential_vertex_coloring(
        graph,
        boost::make_iterator_property_map(vertices.colour_of.begin(), get(boost::vertex_index, graph)));
    CHECK(validate_vertex_colouring(graph, vertices) == std::nullopt);

    const UndirectedGraph undirected(graph);
    Colouring edges{0, std::vector<std::uint32_t>(edge_count(graph))};
    edges.colours = boost::edge_coloring(
        undirected,
        boost::make_iterator_property_map(edges.colour_of.begin(), get(boost::edge_index, undirected)));
    CHECK(validate_edge_colouring(graph, edges) == std::nullopt);
  }
}

TEST_CASE("boost_finds_spanning_trees_and_cut_vertices") {
  for (const CsrGraph& graph : boost_shelf()) {
    const UndirectedGraph undirected(graph);
    std::vector<int> weight(edge_count(graph), 1);
    std::vector<BoostEdge> tree;
    boost::kruskal_minimum_spanning_tree(undirected, std::back_inserter(tree),
                                         boost::weight_map(boost::make_iterator_property_map(
                                             weight.begin(), get(boost::edge_index, undirected))));
    CHECK(tree.size() == vertex_count(graph) - components(graph).count());
  }
  const CsrGraph graph = star(6);
  std::vector<std::uint32_t> cut;
  boost::articulation_points(UndirectedGraph(graph), std::back_inserter(cut));
  CHECK(cut == std::vector<std::uint32_t>{0});
}

TEST_CASE("boost_orders_a_mesh_graph_as_it_orders_its_own_copy") {
  const CsrGraph graph = random_mesh_graph(9, 8, 4);
  const Undirected copy = boost_copy(graph);
  std::vector<std::uint32_t> ours, of_copy;
  boost::cuthill_mckee_ordering(graph, std::back_inserter(ours));
  boost::cuthill_mckee_ordering(copy, std::back_inserter(of_copy));
  CHECK(ours == of_copy);
  ours.clear(), of_copy.clear();
  boost::king_ordering(graph, std::back_inserter(ours));
  boost::king_ordering(copy, std::back_inserter(of_copy));
  CHECK(ours == of_copy);
}

TEST_CASE("graphs_of_boost_come_back_as_they_were") {
  for (const CsrGraph& graph : boost_shelf()) {
    const EdgeListGraph undirected = graph_from(boost_copy(graph));
    CHECK(undirected.graph == graph);
    CHECK(undirected.parallel_edges == 0);
    Directed directed(vertex_count(graph));
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
      for (const std::uint32_t w : neighbours(graph, v)) add_edge(v, w, directed);
    CHECK(graph_from(directed).graph == graph);
    CHECK(graph_from(UndirectedGraph(graph)).graph == graph);
    if (vertex_count(graph) == 0) continue;
    boost::adjacency_matrix<boost::undirectedS> matrix(vertex_count(graph));
    for (const auto& [a, b] : edges_of(graph)) add_edge(a, b, matrix);
    CHECK(graph_from(matrix).graph == graph);
  }
}

TEST_CASE("loops_and_parallel_edges_of_a_boost_graph_are_dropped_and_counted") {
  Undirected model(3);
  add_edge(0, 1, model);
  add_edge(1, 0, model);
  add_edge(2, 2, model);
  const EdgeListGraph made = graph_from(model);
  CHECK(made.graph == graph_from_edges(3, Edges{{0, 1}}).graph);
  CHECK(made.parallel_edges == 1);
  CHECK(made.self_loops == 1);
}

TEST_CASE("a_directed_boost_graph_must_have_both_directions") {
  Directed model(3);
  add_edge(0, 1, model);
  CHECK_THROWS_WITH_AS(static_cast<void>(graph_from(model)),
                       doctest::Contains("vertex 0 has neighbour 1, which does not have it back"),
                       InputError);
}

TEST_CASE("vertices_in_lists_are_numbered_by_the_callers_index") {
  using Listed = boost::adjacency_list<boost::listS, boost::listS, boost::undirectedS,
                                       boost::property<boost::vertex_index_t, std::size_t>>;
  Listed model;
  std::vector<Listed::vertex_descriptor> made;
  for (std::size_t i = 0; i < 4; ++i) made.push_back(add_vertex(model));
  for (std::size_t i = 0; i < 4; ++i) put(boost::vertex_index, model, made[i], 3 - i);
  add_edge(made[0], made[1], model);
  add_edge(made[1], made[3], model);
  CHECK(graph_from(model).graph == graph_from_edges(4, Edges{{3, 2}, {2, 0}}).graph);

  put(boost::vertex_index, model, made[0], 2);
  CHECK_THROWS_WITH_AS(static_cast<void>(graph_from(model)), doctest::Contains("it gives 2 twice"),
                       InputError);
  put(boost::vertex_index, model, made[0], 4);
  CHECK_THROWS_WITH_AS(static_cast<void>(graph_from(model)), doctest::Contains("it gives 4"), InputError);
}

TEST_CASE("the_doors_take_a_boost_graph_as_they_take_ours") {
  const CsrGraph graph = random_mesh_graph(12, 10, 1);
  const Undirected model = boost_copy(graph);
  CHECK(order(model).order == order(graph).order);
  const OrderOptions fill{.method = OrderMethod::minimum_degree};
  CHECK(order(model, fill).order == order(graph, fill).order);
  CHECK(partition(model, 4).part_of == partition(graph, 4).part_of);
  CHECK(colour_vertices(model).colour_of == colour_vertices(graph).colour_of);
}
