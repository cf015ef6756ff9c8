// SPDX-License-Identifier: MIT
#include "leonhard/graph/colouring.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <stop_token>

#include "leonhard/graph/orientation.hpp"
#include "leonhard/mesh/edges.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

std::uint32_t largest_degree(const CsrGraph& graph) {
  std::uint32_t largest = 0;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) largest = std::max(largest, degree(graph, v));
  return largest;
}

EdgeColouring checked(const CsrGraph& graph, const EdgeColouringOptions& options = {}) {
  const EdgeColouring found = colour_edges(graph, options);
  CHECK(validate_edge_colouring(graph, found).value_or("") == "");
  const std::uint32_t delta = largest_degree(graph);
  CHECK(found.colours == delta + (found.count == EdgeColourCount::delta ? 0 : 1));
  return found;
}

CsrGraph petersen() {
  Edges edges;
  for (std::uint32_t i = 0; i < 5; ++i) {
    edges.push_back({i, (i + 1) % 5});
    edges.push_back({i, i + 5});
    edges.push_back({i + 5, (i + 2) % 5 + 5});
  }
  return graph_from_edges(10, edges).graph;
}

CsrGraph random_bipartite(std::uint32_t side, unsigned chance, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Edges edges;
  for (std::uint32_t v = 0; v < side; ++v)
    for (std::uint32_t w = 0; w < side; ++w)
      if (random() % 256 < chance) edges.push_back({v, side + w});
  return renamed(graph_from_edges(2 * side, edges).graph, random_order(2 * side, seed));
}

}  // namespace

TEST_CASE("bipartite_graphs_get_exactly_delta_colours") {  // Koenig 1916
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    CHECK(checked(random_bipartite(25, 20 + 10 * static_cast<unsigned>(seed), seed)).count ==
          EdgeColourCount::delta);
  CHECK(checked(star(300)).colours == 299);
  CHECK(checked(grid(20, 30)).colours == 4);
  CHECK(checked(path(0)).colours == 0);
  CHECK(checked(path(2)).colours == 1);
}

TEST_CASE("chromatic_indices_that_are_known_are_found") {
  for (std::uint32_t n = 3; n < 14; ++n) {
    const EdgeColouring even_or_odd = checked(complete(n));
    CHECK(even_or_odd.colours == (n % 2 == 0 ? n - 1 : n));
    CHECK(even_or_odd.certain);
    CHECK(checked(cycle(n)).colours == (n % 2 == 0 ? 2 : 3));
  }
  for (std::uint32_t n = 5; n < 20; ++n) CHECK(checked(wheel(n)).colours == n - 1);
  const EdgeColouring snark = checked(petersen());  // of the second class though not overfull
  CHECK(snark.colours == 4);
  CHECK_FALSE(snark.certain);
}

TEST_CASE("any_graph_gets_at_most_delta_plus_one_colours") {  // Vizing 1964
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const CsrGraph graph = random_graph(24, 10 + 8 * static_cast<unsigned>(seed), seed);
    static_cast<void>(checked(graph));
    const EdgeColouring without_attempts = checked(graph, {.rounds = 0});
    CHECK(without_attempts.colours <= largest_degree(graph) + 1);
  }
}

TEST_CASE("edges_of_meshes_are_coloured_for_loops") {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const CsrGraph graph = random_mesh_graph(20, 15, seed);
    const Colouring greedy = colour_edges_greedily(graph);
    CHECK_FALSE(validate_edge_colouring(graph, greedy));
    CHECK(greedy.colours <= 2 * largest_degree(graph) - 1);
    CHECK(checked(graph).colours ==
          largest_degree(graph));  // planar of degree 7 or more: Sanders and Zhao 2001
  }
}

TEST_CASE("a_stopped_edge_colouring_is_the_greedy_one_and_says_so") {
  for (const CsrGraph& graph : {random_mesh_graph(60, 60, 1), grid(70, 70), complete(101)})
    for (const double when : {0.0, 0.5}) {
      std::stop_source source;
      double last = 0;
      EdgeColouringOptions options;
      options.progress.stop = source.get_token();
      options.progress.report = [&](std::string_view stage, double fraction) {
        CHECK(stage == "edge colouring");
        last = fraction;
        if (fraction >= when) source.request_stop();
      };
      const EdgeColouring found = colour_edges(graph, options);
      CHECK(found.count == EdgeColourCount::stopped);
      CHECK_FALSE(found.certain);
      CHECK(found.colour_of == colour_edges_greedily(graph).colour_of);
      CHECK_FALSE(validate_edge_colouring(graph, found));
      CHECK(last < when + 0.5);
    }
}

TEST_CASE("edge_numbers_are_those_of_the_meshs_edge_structure") {
  const TriangleMesh mesh = random_triangulation(6, 5, 3);
  const EdgeStructure structure = mesh::build_edges(mesh);
  const auto edges = edges_of(vertex_graph(mesh, structure));
  REQUIRE(edges.size() == structure.edge_count());
  for (const EdgeId e : structure.ends.ids())
    for (std::size_t k = 0; k < 2; ++k) CHECK(edges[e.index()][k] == structure.ends[e][k].raw);
}

TEST_CASE("vertices_get_at_most_one_colour_more_than_the_degeneracy") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const CsrGraph graph = random_graph(40, 50, seed);
    const Colouring found = colour_vertices(graph);
    CHECK_FALSE(validate_vertex_colouring(graph, found));
    CHECK(found.colours <= orient_by_least_degree(graph).max_out_degree() + 1);
  }
  CHECK(colour_vertices(complete(7)).colours == 7);
  CHECK(colour_vertices(grid(9, 9)).colours <= 3);
  CHECK(colour_vertices(random_mesh_graph(12, 12, 1)).colours <= 6);
  CHECK(colour_vertices(path(0)).colours == 0);
}

TEST_CASE("boosts_colourings_are_proper_and_keep_vizings_bound") {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const CsrGraph& graph :
         {random_graph(25, 60, seed), random_mesh_graph(5, 4, seed), complete(7), path(0)}) {
      CHECK_FALSE(validate_vertex_colouring(graph, colour_vertices(graph, VertexColouringMethod::boost)));
      const EdgeColouring found = colour_edges(graph, {.method = EdgeColouringMethod::boost});
      CHECK_FALSE(validate_edge_colouring(graph, found));
      std::uint32_t delta = 0;
      for (std::uint32_t v = 0; v < vertex_count(graph); ++v) delta = std::max(delta, degree(graph, v));
      CHECK(found.colours <= delta + 1);
      CHECK((found.count == EdgeColourCount::delta) == (found.colours <= delta));
    }
}

TEST_CASE("boosts_edge_colouring_stops_when_told_to") {
  const CsrGraph graph = random_mesh_graph(40, 40, 1);
  std::stop_source stop;
  EdgeColouringOptions options{.method = EdgeColouringMethod::boost};
  options.progress.stop = stop.get_token();
  options.progress.report = [&](std::string_view, double fraction) {
    if (fraction > 0) stop.request_stop();
  };
  const EdgeColouring found = colour_edges(graph, options);
  CHECK(found.count == EdgeColourCount::stopped);
  CHECK(found.colour_of == colour_edges_greedily(graph).colour_of);
}

TEST_CASE("validators_name_what_is_wrong_with_a_colouring") {
  const auto vertices = [](std::vector<std::uint32_t> colour_of) {
    return validate_vertex_colouring(path(3), {2, std::move(colour_of)}).value_or("");
  };
  CHECK(vertices({0, 1, 0}) == "");
  CHECK(vertices({0, 1}) == "2 colours for 3 vertices");
  CHECK(vertices({0, 1, 1}) == "neighbours 1 and 2 have one colour");
  CHECK(vertices({0, 2, 1}) == "vertex 1 has colour 2 of 2");
  const auto edges = [](std::vector<std::uint32_t> colour_of) {
    return validate_edge_colouring(path(3), {2, std::move(colour_of)}).value_or("");
  };
  CHECK(edges({0, 1}) == "");
  CHECK(edges({0}) == "1 colours for 2 edges");
  CHECK(edges({1, 1}) == "two edges of colour 1 meet at vertex 1");
  CHECK(edges({1, 2}) == "edge 1 has colour 2 of 2");
}
