// SPDX-License-Identifier: MIT
#include "leonhard/graph/graph_file.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

using Weights = std::vector<std::int64_t>;

std::vector<std::uint32_t> row(const CsrGraph& graph, std::uint32_t v) {
  const auto list = neighbours(graph, v);
  return {list.begin(), list.end()};
}

struct BadText {
  const char* text;
  const char* words;
};

template <class Parse>
void refuse(const std::vector<BadText>& table, const Parse& parse) {
  for (const BadText& bad : table) {
    CAPTURE(bad.text);
    CHECK_THROWS_WITH_AS(static_cast<void>(parse(bad.text)), doctest::Contains(bad.words), InputError);
  }
}

}  // namespace

TEST_CASE("metis_graphs_are_read_with_comments_and_isolated_vertices") {
  const GraphFile file = parse_metis_graph("% a path and a lone vertex\n4 2\n2\n1 4\n\n% here\n2\n", "t");
  CHECK(vertex_count(file.graph) == 4);
  CHECK(row(file.graph, 1) == std::vector<std::uint32_t>{0, 3});
  CHECK(row(file.graph, 2).empty());
  CHECK(file.components == 2);
  CHECK(file.weights_each == 0);
  CHECK(file.edge_weights.empty());
  CHECK_FALSE(validate(file.graph));
}

TEST_CASE("metis_graphs_are_read_with_weights_of_vertices_and_edges") {
  const GraphFile file = parse_metis_graph("3 2 111 2\n9 4 0 2 7\n9 5 1 3 8 1 7\n9 6 2 2 8\n", "t");
  CHECK(file.weights_each == 2);
  CHECK(file.vertex_weights == Weights{4, 0, 5, 1, 6, 2});
  CHECK(file.edge_weights == Weights{7, 7, 8, 8});
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("sizes") != std::string::npos);
}

TEST_CASE("self_loops_and_parallel_edges_of_files_are_dropped_and_counted") {
  const GraphFile file = parse_metis_graph("3 4\n1 2 2\n1 1 3\n2\n", "t");
  CHECK(edge_count(file.graph) == 2);
  CHECK(file.self_loops == 1);
  CHECK(file.parallel_edges == 1);
  const GraphFile list = parse_edge_list("0 1\n1 0\n2 2\n1 2\n", "t");
  CHECK(edge_count(list.graph) == 2);
  CHECK(list.self_loops == 1);
  CHECK(list.parallel_edges == 1);
}

TEST_CASE("bad_metis_graphs_are_refused_with_their_line") {
  refuse({{"", "vertices"},
          {"x 1\n", "t:1: found \"x\""},
          {"-1 1\n", "t:1"},
          {"99 1\n2\n1\n", "t:1: the number of vertices"},
          {"2 9\n2\n1\n", "t:1: the number of edges"},
          {"2 1 7\n2\n1\n", "t:1: found \"7\""},
          {"2 1 11 0\n1 2 1\n1 1 1\n", "t:1: 0 weights"},
          {"2 1 0 1 5\n2\n1\n", "t:1"},
          {"3 1\n2\n1\n", "neighbours of vertex 3"},
          {"2 1\n2\n1\n2\n", "t:4: found a line after"},
          {"2 1\n3\n1\n", "t:2: vertex 1 has neighbour 3"},
          {"2 1\n0\n1\n", "t:2: vertex 1 has neighbour 0"},
          {"2 1\n2 x\n1\n", "t:2: found \"x\""},
          {"3 1\n2\n\n1\n", "t:2: vertex 1 has an edge to vertex 2, but 2 has none to 1"},
          {"3 2\n2\n1\n\n", "the header declares 2 edges"},
          {"2 1 1\n2 5\n1 6\n", "t:2: the edge from vertex 1 to vertex 2 weighs 5, in line 3 it weighs 6"},
          {"2 1 1\n2 0\n1 0\n", "t:2: an edge's weight is 0"},
          {"2 1 1\n2\n1 1\n", "t:2: line ends where an edge's weight"},
          {"2 1 10\n-4 2\n1 1\n", "t:2: a vertex's weight is -4"},
          {"2 1 10\n\n1 1\n", "t:2: line ends where a vertex's weight"}},
         [](const char* text) { return parse_metis_graph(text, "t"); });
}

TEST_CASE("a_graph_survives_its_way_through_metis_format") {
  const CsrGraph graph = disjoint_union({path(1), random_mesh_graph(5, 4, 3), path(1), cycle(4), path(1)});
  const GraphFile again = parse_metis_graph(format_metis_graph(graph), "again");
  CHECK(vertex_count(again.graph) == vertex_count(graph));
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) CHECK(row(again.graph, v) == row(graph, v));
  CHECK(again.components == components(graph).count());

  const Weights of_vertices{1, 0, 2, 0, 3, 9}, of_edges{4, 4, 5, 5};
  const GraphFile weighted =
      parse_metis_graph(format_metis_graph(path(3), of_vertices, of_edges), "weighted");
  CHECK(weighted.weights_each == 2);
  CHECK(weighted.vertex_weights == of_vertices);
  CHECK(weighted.edge_weights == of_edges);
  CHECK_THROWS_AS(static_cast<void>(format_metis_graph(path(3), Weights{1, 2}, {})), InputError);
  CHECK_THROWS_AS(static_cast<void>(format_metis_graph(path(3), {}, Weights{1, 2})), InputError);
  CHECK_THROWS_AS(static_cast<void>(format_metis_graph(path(3), {}, Weights{0, 0, 1, 1})), InputError);
}

TEST_CASE("matrix_market_matrices_give_the_graph_of_their_pattern") {
  const GraphFile symmetric = parse_matrix_market(
      "%%MatrixMarket matrix coordinate real symmetric\n% comment\n3 3 4\n1 1 2.0\n2 1 -1e0\n3 2 -1\n3 3 2\n",
      "t");
  CHECK(row(symmetric.graph, 1) == std::vector<std::uint32_t>{0, 2});
  CHECK(symmetric.self_loops == 2);
  CHECK(symmetric.components == 1);
  const GraphFile general = parse_matrix_market(
      "%%matrixmarket Matrix Coordinate PATTERN general\n3 3 4\n1 2\n2 1\n2 3\n3 2\n", "t");
  CHECK(row(general.graph, 1) == std::vector<std::uint32_t>{0, 2});
  CHECK(general.warnings.empty());
}

TEST_CASE("bad_matrix_market_files_are_refused_with_their_line") {
  const std::string head = "%%MatrixMarket matrix coordinate pattern general\n";
  const auto with_head = [&](const char* rest) { return parse_matrix_market(head + rest, "t"); };
  refuse({{"2 3 1\n1 2\n", "t:2: the matrix has 2 rows and 3 columns"},
          {"2 2 9\n1 2\n", "t:2: the number of entries"},
          {"4000000000 4000000000 1\n1 2\n", "t:2: the matrix has 4000000000 rows"},
          {"2 2 2\n1 2\n2 3\n", "t:4: found column 3"},
          {"2 2 2\n0 2\n2 1\n", "t:3: found row 0"},
          {"2 2 2\n1 2 5\n2 1\n", "t:3: found \"5\" where the line should end"},
          {"2 2 1\n1 2\n", "t:3: vertex 1 has an edge to vertex 2, but 2 has none"},
          {"2 2 2\n1 2\n1 \n", "t:4: line ends where column"},
          {"2 2 1\n2 2\n1 1\n", "t:4: found a line after"}},
         with_head);
  const auto whole = [](const char* text) { return parse_matrix_market(text, "t"); };
  refuse({{"1 1 0\n", "t:1: found \"1\" where %%MatrixMarket"},
          {"%%MatrixMarket matrix coordinate octonion general\n1 1 0\n", "t:1: found \"octonion\""},
          {"%%MatrixMarket matrix coordinate real odd\n1 1 0\n", "t:1: found \"odd\""},
          {"%%MatrixMarket matrix coordinate real symmetric\n1 1 1\n1 1 nan\n", "t:3: \"nan\""}},
         whole);
}

TEST_CASE("edge_lists_are_read_with_headers_commas_and_weights") {
  const GraphFile plain = parse_edge_list("# edges\n0 1\n% more\n2 1\n", "t");
  CHECK(row(plain.graph, 1) == std::vector<std::uint32_t>{0, 2});
  CHECK(plain.edge_weights.empty());
  const GraphFile csv = parse_edge_list("source,target,weight\n0,1,5\n3,1,6\n", "t");
  CHECK(vertex_count(csv.graph) == 4);
  CHECK(csv.edge_weights == Weights{5, 5, 6, 6});
  CHECK(csv.components == 2);
  CHECK(parse_edge_list("1 2\n2 3\n", "t").warnings.size() == 1);
}

TEST_CASE("vertices_of_edge_lists_may_have_names_and_matrices_may_be_dense") {
  const GraphFile named = parse_edge_list("Rome,Paris\nParis,Oslo\n", "t");
  CHECK(vertex_count(named.graph) == 3);
  CHECK(row(named.graph, 1) == std::vector<std::uint32_t>{0, 2});
  const GraphFile dense =
      parse_matrix_market("%%MatrixMarket matrix array real general\n2 2\n1\n2\n2\n0\n", "t");
  CHECK(vertex_count(dense.graph) == 2);
  CHECK(row(dense.graph, 0) == std::vector<std::uint32_t>{1});
}

TEST_CASE("bad_edge_lists_are_refused_with_their_line") {
  refuse({{"# nothing\n", "no edge was found"},
          {"0 1\n1\n", "t:2: line ends where a vertex"},
          {"0 1\n1 -2\n", "t:2: vertex -2 is out of range"},
          {"0 1\n1 4294967295\n", "t:2: vertex 4294967295 is out of range"},
          {"0 1\n1 4000000000\n", "t:2: vertex 4000000000 in a list of 2 edges"},
          {"0 1\n1 2 3\n", "t:2: found \"3\""},
          {"0 1 4\n1 2\n", "t:2: line ends where an edge's weight"}},
         [](const char* text) { return parse_edge_list(text, "t"); });
}

TEST_CASE("coordinates_are_read_with_and_without_a_header") {
  const VertexCoordinates plain = parse_coordinates("0 1\n2 3\n", "t", 2);
  CHECK(plain.dimension == 2);
  CHECK(plain.points[1] == Point3{2, 3, 0});
  const VertexCoordinates scotch = parse_coordinates("3\n2\n2 4 5 6\n1 1 2 3\n", "t", 2);
  CHECK(scotch.dimension == 3);
  CHECK(scotch.points[0] == Point3{1, 2, 3});
  refuse({{"0 1\n", "t:1: 1 vertices have coordinates, the graph has 2"},
          {"0 1\n2\n", "t:2: the line has 1 coordinates"},
          {"0.5 \n2 3\n", "t:1"},
          {"0 1\n2 3 4\n", "t:2: the line has 3 coordinates, those before it 2"},
          {"0 1\n2 inf\n", "t:2: \"inf\" is not finite"},
          {"4\n2\n", "t:1: the dimension is 4"},
          {"2\n3\n", "t:2"},
          {"2\n2\n0 1 1\n0 2 2\n", "t:4: vertex 0 is repeated"},
          {"2\n2\n0 1 1\n2 2 2\n", "t:4: vertex 2 is repeated or does not exist"}},
         [](const char* text) { return parse_coordinates(text, "t", 2); });
}

TEST_CASE("of_edges_listed_twice_the_first_weight_counts") {
  const GraphFile list = parse_edge_list("0 1 5\n1 2 4\n0 1 7\n", "t");
  CHECK(list.edge_weights == Weights{5, 5, 4, 4});
  CHECK(list.parallel_edges == 1);
  const GraphFile twice_one_way =
      parse_matrix_market("%%MatrixMarket matrix coordinate pattern general\n2 2 3\n1 2\n1 2\n2 1\n", "t");
  CHECK(twice_one_way.parallel_edges == 1);
  CHECK(edge_count(twice_one_way.graph) == 1);
}

TEST_CASE("complex_matrices_have_two_values_an_entry") {
  const GraphFile file = parse_matrix_market(
      "%%MatrixMarket matrix coordinate complex hermitian\n3 3 2\n2 1 0.5 1\n3 2 0 -1\n", "t");
  CHECK(edge_count(file.graph) == 2);
  CHECK_THROWS_AS(static_cast<void>(parse_matrix_market(
                      "%%MatrixMarket matrix coordinate complex hermitian\n3 3 1\n2 1 0.5\n", "t")),
                  InputError);
}

TEST_CASE("graph_files_of_each_format_and_coordinates_beside_them_are_read") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "leonhard_graph_file_test";
  std::filesystem::remove_all(folder);  // of a run that broke off
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const char* text) {
    std::ofstream(folder / name) << text;
    return folder / name;
  };
  const auto metis = write("path.graph", "3 2\n2\n1 3\n2\n");
  const auto matrix =
      write("path.mtx", "%%MatrixMarket matrix coordinate pattern symmetric\n3 3 2\n2 1\n3 2\n");
  const auto list = write("path.edges", "0 1\n1 2\n");
  for (const auto& file : {metis, matrix, list}) {
    const CsrGraph graph = read_graph(file).graph;
    CHECK(edge_count(graph) == 2);
    CHECK(row(graph, 1) == std::vector<std::uint32_t>{0, 2});
  }
  CHECK_FALSE(read_coordinates_beside(metis, 3));
  write("path.xyz", "0 1\n2 3\n4 5\n");
  const auto beside = read_coordinates_beside(metis, 3);
  REQUIRE(beside.has_value());
  CHECK(beside->points[2] == Point3{4, 5, 0});
  std::filesystem::remove_all(folder);
}

TEST_CASE("read_graph_takes_the_format_from_the_extension") {
  CHECK_THROWS_WITH_AS(static_cast<void>(read_graph("nowhere.graph")), doctest::Contains("does not exist"),
                       InputError);
  CHECK_THROWS_WITH_AS(static_cast<void>(read_graph("mesh.grph")), doctest::Contains(".graph"), InputError);
  CHECK_FALSE(read_coordinates_beside("nowhere.graph", 3));
}
