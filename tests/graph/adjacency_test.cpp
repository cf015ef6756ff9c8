// SPDX-License-Identifier: MIT
#include "leonhard/graph/adjacency.hpp"

#include <doctest/doctest.h>

#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

/// What is wrong with the arrays, as the error says it.
std::string refusal(const std::vector<std::int32_t>& xadj, const std::vector<std::int32_t>& adjncy) {
  try {
    static_cast<void>(graph_from_adjacency(xadj, adjncy));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a_graph_goes_through_xadj_and_adjncy_and_back") {
  for (const CsrGraph& graph :
       {path(0), path(1), path(6), star(7), random_graph(25, 50, 1), random_mesh_graph(8, 6, 3)}) {
    const AdjacencySpans spans = adjacency_spans(graph);
    CHECK(spans.xadj.size() == vertex_count(graph) + std::size_t{1});
    CHECK(spans.adjncy.size() == 2 * edge_count(graph));
    CHECK(graph_from_adjacency(spans.xadj, spans.adjncy).graph == graph);
    const AdjacencyArrays arrays = adjacency_arrays(graph);
    CHECK(std::ranges::equal(arrays.xadj, spans.xadj));
    CHECK(graph_from_adjacency(arrays.xadj, arrays.adjncy).graph == graph);
  }
}

TEST_CASE("spans_of_a_graph_are_its_own_memory") {
  const CsrGraph graph = cycle(5);
  CHECK(static_cast<const void*>(adjacency_spans(graph).adjncy.data()) == graph.rows().links().data());
}

TEST_CASE("rows_of_adjncy_may_come_in_any_sequence_with_loops_and_repetitions") {
  const std::vector<std::int64_t> xadj{0, 4, 7, 8}, adjncy{2, 1, 0, 1, 0, 0, 1, 0};
  const EdgeListGraph made = graph_from_adjacency(xadj, adjncy);
  CHECK(made.graph == graph_from_edges(3, Edges{{0, 1}, {0, 2}}).graph);
  CHECK(made.self_loops == 2);
  CHECK(made.parallel_edges == 1);
}

TEST_CASE("adjacency_arrays_that_are_no_graph_are_refused_by_name") {
  CHECK(refusal({}, {}).find("xadj: it is empty") != std::string::npos);
  CHECK(refusal({1, 1}, {0}).find("it begins with 1") != std::string::npos);
  CHECK(refusal({0, 2, 1, 2}, {1, 2}).find("it descends from 2 to 1 at vertex 1") != std::string::npos);
  CHECK(refusal({0, 1, 2}, {1, 0, 1}).find("it ends with 2, adjncy holds 3") != std::string::npos);
  CHECK(refusal({0, 1, 2}, {1, 2}).find("vertex 1 has neighbour 2, the graph has 2") != std::string::npos);
  CHECK(refusal({0, 1, 2}, {1, -1}).find("vertex 1 has neighbour -1") != std::string::npos);
  CHECK(refusal({0, 1, 1}, {1}).find("vertex 0 has neighbour 1, which does not have it back") !=
        std::string::npos);
  CHECK(refusal({0, 1, 2}, {1, 0}).empty());
}
