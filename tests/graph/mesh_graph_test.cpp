// SPDX-License-Identifier: MIT
#include "leonhard/graph/mesh_graph.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <boost/graph/connected_components.hpp>
#include <set>

#include "leonhard/graph/boost_graph.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

TEST_CASE("graph_from_edges_drops_and_counts_loops_and_repetitions") {
  const Edges edges{{0, 1}, {1, 0}, {2, 2}, {1, 2}, {0, 1}, {3, 3}};
  const EdgeListGraph made = graph_from_edges(4, edges);
  CHECK(made.self_loops == 2);
  CHECK(made.parallel_edges == 2);
  CHECK(edge_count(made.graph) == 2);
  CHECK(degree(made.graph, 1) == 2);
  CHECK(degree(made.graph, 3) == 0);
  CHECK(validate(made.graph) == std::nullopt);
}

TEST_CASE("graph_from_edges_refuses_an_end_out_of_range_and_names_it") {
  const Edges edges{{0, 1}, {1, 7}};
  CHECK_THROWS_WITH_AS(static_cast<void>(graph_from_edges(4, edges)),
                       doctest::Contains("edge 1 ends at vertex 7"), InputError);
}

TEST_CASE("empty_graph_is_a_graph") {
  const CsrGraph empty = graph_from_edges(0, {}).graph;
  CHECK(vertex_count(empty) == 0);
  CHECK(edge_count(empty) == 0);
  CHECK(components(empty).count() == 0);
  CHECK(validate(empty) == std::nullopt);
}

TEST_CASE("validate_finds_a_one_way_edge_and_an_unsorted_row") {
  const auto broken = validate(CsrGraph({{0, 1, 2, 3}, {1, 2, 1}}));
  REQUIRE(broken.has_value());
  CHECK(broken->find("vertex 0 has neighbour 1") != std::string::npos);
  CHECK(validate(CsrGraph({{0, 1, 3}, {1, 0, 1}})) == "vertex 1 is its own neighbour");
  CHECK(validate(CsrGraph({{0, 2, 3, 4}, {2, 1, 0, 0}})).has_value());
}

TEST_CASE("vertex_graph_has_the_edges_of_the_triangles") {
  const TriangleMesh mesh = random_triangulation(7, 5, 3);
  const CsrGraph graph = vertex_graph(mesh, mesh::build_edges(mesh));
  CHECK(validate(graph) == std::nullopt);
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& corners : mesh.corners)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::uint32_t>(corners[i].raw);
      const auto b = static_cast<std::uint32_t>(corners[(i + 1) % 3].raw);
      sides.insert({a, b});
      sides.insert({b, a});
    }
  std::set<std::pair<std::uint32_t, std::uint32_t>> arcs;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v)) arcs.insert({v, w});
  CHECK(arcs == sides);
}

TEST_CASE("dual_graph_joins_triangles_that_share_two_corners") {
  const TriangleMesh mesh = random_triangulation(6, 4, 11);
  const CsrGraph dual = dual_graph(mesh);
  CHECK(validate(dual) == std::nullopt);
  REQUIRE(vertex_count(dual) == mesh.triangle_count());
  for (const TriangleId s : mesh.corners.ids())
    for (const TriangleId t : mesh.corners.ids()) {
      if (s == t) continue;
      const auto shared = std::ranges::count_if(
          mesh.corners[s], [&](VertexId v) { return std::ranges::count(mesh.corners[t], v) > 0; });
      const bool joined = std::ranges::binary_search(neighbours(dual, static_cast<std::uint32_t>(s.raw)),
                                                     static_cast<std::uint32_t>(t.raw));
      CHECK(joined == (shared == 2));
    }
}

TEST_CASE("dual_graph_refuses_neighbours_that_are_missing_or_one_sided") {
  TriangleMesh mesh = random_triangulation(2, 2, 1);
  TriangleMesh without = mesh;
  without.neighbours.clear();
  CHECK_THROWS_AS(static_cast<void>(dual_graph(without)), InputError);
  mesh.neighbours[TriangleId{0}] = {};
  CHECK_THROWS_WITH_AS(static_cast<void>(dual_graph(mesh)),
                       doctest::Contains("names triangle 0 as neighbour"), InputError);
}

TEST_CASE("vertex_graph_refuses_edges_of_a_larger_mesh") {
  const TriangleMesh small = random_triangulation(2, 2, 1), large = random_triangulation(4, 4, 1);
  CHECK_THROWS_AS(static_cast<void>(vertex_graph(small, mesh::build_edges(large))), InputError);
}

TEST_CASE("vertex_graph_refuses_edges_of_another_mesh_of_the_same_size") {
  const TriangleMesh mesh = random_triangulation(3, 3, 1);
  EdgeStructure edges = mesh::build_edges(random_triangulation(3, 3, 2));
  REQUIRE(edges.edge_count() == mesh::build_edges(mesh).edge_count());
  CHECK_THROWS_WITH_AS(static_cast<void>(vertex_graph(mesh, edges)), doctest::Contains("beside it, which"),
                       InputError);

  edges = mesh::build_edges(mesh);
  CHECK(validate(vertex_graph(mesh, edges)) == std::nullopt);
  const EdgeStructure none;
  CHECK_THROWS_WITH_AS(static_cast<void>(vertex_graph(mesh, none)), doctest::Contains("they have 0 sides"),
                       InputError);
  edges.sides[EdgeId{0}] = {};
  CHECK_THROWS_WITH_AS(static_cast<void>(vertex_graph(mesh, edges)),
                       doctest::Contains("edge 0 has no triangle"), InputError);
}

TEST_CASE("arc_lengths_are_distances_in_the_sequence_of_the_arcs") {
  const CsrGraph graph = path(3);
  const std::vector<Point2> points{{0, 0}, {3, 4}, {3, 5}};
  CHECK(arc_lengths(graph, points) == std::vector<double>{5, 5, 1, 1});
  const std::vector<Point3> in_space{{0, 0, 0}, {2, 3, 6}, {2, 3, 5}};
  CHECK(arc_lengths(graph, in_space) == std::vector<double>{7, 7, 1, 1});
  CHECK_THROWS_AS(static_cast<void>(arc_lengths(path(4), points)), InputError);
}

TEST_CASE("graph_from_arcs_wants_both_directions") {
  const Edges arcs{{1, 0}, {2, 1}, {0, 1}, {1, 2}, {2, 2}, {0, 1}};
  const EdgeListGraph made = graph_from_arcs(3, arcs);
  CHECK(made.graph == path(3));
  CHECK(made.self_loops == 1);
  CHECK(made.parallel_edges == 1);
  const Edges one_way{{0, 1}, {1, 0}, {1, 2}};
  CHECK_THROWS_WITH_AS(static_cast<void>(graph_from_arcs(3, one_way)),
                       doctest::Contains("vertex 1 has neighbour 2, which does not have it back"),
                       InputError);
  CHECK_THROWS_AS(static_cast<void>(graph_from_arcs(2, arcs)), InputError);
}

TEST_CASE("components_agree_with_boost") {
  const CsrGraph graph =
      renamed(disjoint_union({grid(4, 5), path(7), path(1), cycle(9), path(1)}), random_order(38, 5));
  const Components ours = components(graph);
  std::vector<std::uint32_t> theirs(vertex_count(graph));
  const auto count = boost::connected_components(graph, theirs.data());
  CHECK(ours.count() == count);
  CHECK(ours.component_of == theirs);  // both number components by their smallest vertex
  for (std::uint32_t c = 0; c < ours.count(); ++c) CHECK(ours.sizes[c] == std::ranges::count(theirs, c));
}

TEST_CASE("subgraph_keeps_exactly_the_edges_inside_in_the_given_numbering") {
  const CsrGraph graph = random_mesh_graph(6, 6, 2);
  SubgraphExtractor extract(graph);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    std::vector<std::uint32_t> chosen = random_order(vertex_count(graph), seed);
    chosen.resize(20);
    const CsrGraph piece = extract(chosen);
    CHECK(validate(piece) == std::nullopt);
    for (std::uint32_t i = 0; i < 20; ++i)
      for (std::uint32_t j = 0; j < 20; ++j)
        CHECK(std::ranges::binary_search(neighbours(piece, i), j) ==
              std::ranges::binary_search(neighbours(graph, chosen[i]), chosen[j]));
  }
}

TEST_CASE("subgraph_of_a_repeated_vertex_is_refused_and_leaves_the_extractor_fit_for_use") {
  const CsrGraph graph = path(5);
  SubgraphExtractor extract(graph);
  CHECK_THROWS_AS(static_cast<void>(extract(std::vector<std::uint32_t>{1, 2, 1})), InputError);
  CHECK_THROWS_AS(static_cast<void>(extract(std::vector<std::uint32_t>{1, 5})), InputError);
  CHECK(edge_count(extract(std::vector<std::uint32_t>{2, 1})) == 1);
}

TEST_CASE("graphs_of_tetrahedra_have_their_edges_and_faces") {
  TetMesh mesh;  // two tetrahedra on a common face
  mesh.points = PerId<VertexId, Point3>(std::vector<Point3>(5));
  const auto v = [](IdRaw raw) { return VertexId{raw}; };
  mesh.corners.push_back({v(0), v(1), v(2), v(3)});
  mesh.corners.push_back({v(1), v(2), v(3), v(4)});
  const CsrGraph vertices = vertex_graph(mesh);
  CHECK(edge_count(vertices) == 9);  // all pairs but 0-4
  CHECK_FALSE(std::ranges::binary_search(neighbours(vertices, 0), 4U));
  CHECK_FALSE(validate(vertices));

  CHECK_THROWS_AS(static_cast<void>(dual_graph(mesh)), InputError);  // no neighbours yet
  mesh.neighbours = PerId<TetId, std::array<MaybeId<TetId>, 4>>(2);
  mesh.neighbours[TetId{0}][0] = TetId{1};
  mesh.neighbours[TetId{1}][3] = TetId{0};
  CHECK(edge_count(dual_graph(mesh)) == 1);
  mesh.neighbours[TetId{1}][3] = {};
  CHECK_THROWS_AS(static_cast<void>(dual_graph(mesh)), InputError);
  mesh.corners[TetId{1}][3] = v(5);
  CHECK_THROWS_AS(static_cast<void>(vertex_graph(mesh)), InputError);
  mesh.corners[TetId{1}][3] = v(1);
  CHECK_THROWS_AS(static_cast<void>(vertex_graph(mesh)), InputError);
}
