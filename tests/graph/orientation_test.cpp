// SPDX-License-Identifier: MIT
#include "leonhard/graph/orientation.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "leonhard/graph/colouring.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/structures/out_degree_list.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

/// A triangulation of the sphere: vertices put one after another into a random triangle.
CsrGraph stacked_triangulation(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Edges edges{{0, 1}, {1, 2}, {0, 2}};
  std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {0, 1, 2}};
  for (std::uint32_t v = 3; v < n; ++v) {
    const std::size_t f = random() % faces.size();
    const auto [a, b, c] = faces[f];
    for (const std::uint32_t corner : {a, b, c}) edges.push_back({corner, v});
    faces[f] = {a, b, v};
    faces.push_back({b, c, v});
    faces.push_back({a, c, v});
  }
  return renamed(graph_from_edges(n, edges).graph, random_order(n, seed));
}

/// A cycle with chords that do not cross, from a random triangulation of the polygon.
CsrGraph outerplanar(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Edges edges;
  std::vector<std::uint32_t> polygon = random_order(n, seed);
  for (std::uint32_t i = 0; i < n; ++i) edges.push_back({polygon[i], polygon[(i + 1) % n]});
  while (polygon.size() > 3) {  // cut an ear
    const std::size_t at = random() % polygon.size(), size = polygon.size();
    edges.push_back({polygon[(at + size - 1) % size], polygon[(at + 1) % size]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return graph_from_edges(n, edges).graph;
}

CsrGraph random_tree(std::uint32_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Edges edges;
  for (std::uint32_t v = 1; v < n; ++v) edges.push_back({static_cast<std::uint32_t>(random() % v), v});
  return renamed(graph_from_edges(n, edges).graph, random_order(n, seed));
}

/// Two grids and a K4 with one vertex in common.
CsrGraph with_cut_vertex() {
  Edges edges;
  const CsrGraph square = grid(4, 4), four = complete(4);
  const auto add = [&](const CsrGraph& graph, std::uint32_t shift) {
    for (const auto& [a, b] : edges_of(graph))
      edges.push_back({a == 0 ? 0 : a + shift, b == 0 ? 0 : b + shift});
  };
  add(square, 0);
  add(square, 15);
  add(four, 30);
  return graph_from_edges(34, edges).graph;
}

/// Every edge of the graph taken out with the given chance in 256.
CsrGraph thinned(const CsrGraph& graph, unsigned chance, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Edges kept;
  for (const auto& edge : edges_of(graph))
    if (random() % 256 >= chance) kept.push_back(edge);
  return graph_from_edges(vertex_count(graph), kept).graph;
}

CsrGraph complete_bipartite(std::uint32_t a, std::uint32_t b) {
  Edges edges;
  for (std::uint32_t v = 0; v < a; ++v)
    for (std::uint32_t w = 0; w < b; ++w) edges.push_back({v, a + w});
  return graph_from_edges(a + b, edges).graph;
}

void check_three_bounded(const CsrGraph& graph) {
  const PlanarOrientation found = orient_planar(graph);
  REQUIRE(found.outcome == OrientationOutcome::three_bounded);
  CHECK(found.orientation.max_out_degree() <= 3);
  CHECK(validate(graph, found.orientation).value_or("") == "");
  CHECK(found.removed.size() == vertex_count(graph));
}

}  // namespace

TEST_CASE("planar_graphs_of_every_kind_get_at_most_three_outgoing_edges") {
  for (std::uint32_t n : {1U, 2U, 3U, 4U, 7U, 50U}) {
    check_three_bounded(path(n));
    check_three_bounded(star(n));
    check_three_bounded(random_tree(n, n));
  }
  for (std::uint32_t n : {4U, 5U, 6U, 31U}) check_three_bounded(wheel(n));
  check_three_bounded(path(0));
  check_three_bounded(complete(4));
  check_three_bounded(with_cut_vertex());
  check_three_bounded(complete_bipartite(2, 40));
  check_three_bounded(disjoint_union({complete(4), path(1), wheel(7), grid(5, 4), path(3), path(1)}));
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const CsrGraph stacked = stacked_triangulation(60, seed), mesh = random_mesh_graph(9, 7, seed);
    check_three_bounded(stacked);
    check_three_bounded(thinned(stacked, 60, seed));
    check_three_bounded(mesh);
    check_three_bounded(renamed(thinned(mesh, 100, seed), random_order(80, seed)));
    check_three_bounded(outerplanar(40, seed));
  }
}

TEST_CASE("graphs_that_are_not_planar_are_named_and_oriented_by_least_degree") {
  for (const std::uint32_t n : {8U, 12U}) {
    const PlanarOrientation found = orient_planar(complete(n));
    CHECK(found.outcome == OrientationOutcome::not_planar);
    CHECK(found.orientation.max_out_degree() == n - 1);  // its degeneracy
    CHECK_FALSE(validate(complete(n), found.orientation));
    CHECK(found.removed.empty());
  }
}

TEST_CASE("whatever_orient_planar_says_of_random_graphs_is_true") {
  std::size_t refused = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const CsrGraph graph = random_graph(14, 20 + static_cast<unsigned>(seed) * 3, seed);
    const PlanarOrientation found = orient_planar(graph);
    CHECK_FALSE(validate(graph, found.orientation));
    if (is_planar(graph)) CHECK(found.outcome == OrientationOutcome::three_bounded);
    if (found.outcome == OrientationOutcome::three_bounded) CHECK(found.orientation.max_out_degree() <= 3);
    refused += found.outcome == OrientationOutcome::not_planar ? 1 : 0;
  }
  CHECK(refused > 10);
  CHECK(refused < 60);
}

TEST_CASE("planarity_is_that_of_kuratowski") {
  CHECK_FALSE(is_planar(complete(5)));
  CHECK_FALSE(is_planar(complete_bipartite(3, 3)));
  CHECK(is_planar(complete(4)));
  CHECK(is_planar(complete_bipartite(2, 9)));
  CHECK(is_planar(path(0)));
  CHECK(is_planar(random_mesh_graph(6, 6, 1)));
}

TEST_CASE("a_boundary_given_is_removed_before_what_lies_inside") {
  const CsrGraph mesh = random_mesh_graph(6, 6, 2);
  std::vector<std::uint32_t> boundary;
  for (std::uint32_t v = 0; v < 49; ++v)
    if (v % 7 == 0 || v % 7 == 6 || v < 7 || v >= 42) boundary.push_back(v);
  const PlanarOrientation found = orient_planar(mesh, boundary);
  CHECK(found.outcome == OrientationOutcome::three_bounded);
  CHECK(found.orientation.max_out_degree() <= 3);
  CHECK(std::ranges::find(boundary, found.removed.front()) != boundary.end());
  CHECK_THROWS_AS(static_cast<void>(orient_planar(mesh, std::vector<std::uint32_t>{49})), InputError);
}

TEST_CASE("a_meshs_out_degree_list_has_at_most_three_heads_a_vertex") {
  const TriangleMesh mesh = random_triangulation(12, 8, 5);
  const EdgeStructure edges = mesh::build_edges(mesh);
  const PlanarOrientation found = orient_planar(vertex_graph(mesh, edges));
  const OutDegreeList list = mesh::out_degree_list(edges, tails(edges, found.orientation));
  CHECK(list.edge_count() == edges.edge_count());
  for (const VertexId v : mesh.points.ids()) CHECK(list.out_degree(v) <= 3);
  for (const auto& [a, b] : edges.ends) CHECK(list.has_edge(a, b));
  CHECK_THROWS_AS(static_cast<void>(tails(edges, orient_planar(path(117)).orientation)), InputError);
}

TEST_CASE("the_least_degree_sequence_attains_the_degeneracy") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const CsrGraph graph = random_graph(30, 10 + static_cast<unsigned>(seed), seed);
    // By brute force: the largest least degree met while vertices of least degree are removed.
    std::vector<std::uint32_t> left(30);
    for (std::uint32_t v = 0; v < 30; ++v) left[v] = degree(graph, v);
    std::vector<char> gone(30, 0);
    std::uint32_t degeneracy = 0;
    for (int step = 0; step < 30; ++step) {
      std::uint32_t least = 30;
      for (std::uint32_t v = 0; v < 30; ++v)
        if (gone[v] == 0 && (least == 30 || left[v] < left[least])) least = v;
      degeneracy = std::max(degeneracy, left[least]);
      gone[least] = 1;
      for (const std::uint32_t w : neighbours(graph, least)) --left[w];
    }
    CHECK(orient_by_least_degree(graph).max_out_degree() == degeneracy);
    CHECK_FALSE(validate(graph, orient_by_least_degree(graph)));
  }
}

TEST_CASE("validate_names_what_is_wrong_with_an_orientation") {
  const CsrGraph graph = path(3);
  Orientation good = orient_by_least_degree(graph);
  CHECK_FALSE(validate(graph, good));
  CHECK(validate(path(4), good)->find("3 vertices") != std::string::npos);
  CHECK(validate(cycle(3), good)->find("2 edges") != std::string::npos);
  CHECK(validate(graph, Orientation{{{0, 1, 2, 2}, {1, 0}}})->find("both ways") != std::string::npos);
  CHECK(validate(graph, Orientation{{{0, 2, 2, 2}, {1, 2}}})->find("no edge from vertex 0 to 2") !=
        std::string::npos);
  CHECK(validate(graph, Orientation{{{0, 0, 2, 2}, {2, 0}}})->find("ascend") != std::string::npos);
}
