// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering/nested_dissection.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>

#include "leonhard/graph/fill.hpp"
#include "leonhard/graph/ordering/minimum_degree.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

TEST_CASE("a_path_is_dissected_with_less_fill_than_its_length") {
  const CsrGraph graph = renamed(path(1000), random_order(1000, 2));
  const OrderResult found = nested_dissection(graph, {.leaf = 10});
  CHECK(is_permutation_of_all(graph, found.order));
  CHECK(cholesky_fill(graph, found.order).fill < 1000);
}

TEST_CASE("nested_dissection_fills_a_large_mesh_less_than_minimum_degree") {
  const CsrGraph graph = renamed(grid(70, 70), random_order(4900, 7));
  const auto dissected = cholesky_fill(graph, nested_dissection(graph).order);
  CHECK(dissected.nonzeros < cholesky_fill(graph, minimum_degree(graph)).nonzeros);
}

TEST_CASE("components_are_dissected_one_by_one") {
  const CsrGraph graph = disjoint_union({grid(20, 20), path(7), grid(30, 5), path(1)});
  const OrderResult found = nested_dissection(graph, {.leaf = 20});
  CHECK(is_permutation_of_all(graph, found.order));
  CHECK(found.outcome == OrderOutcome::done);
  const auto alone = [](const CsrGraph& part) {
    return cholesky_fill(part, nested_dissection(part, {.leaf = 20}).order).nonzeros;
  };
  const auto together = static_cast<double>(cholesky_fill(graph, found.order).nonzeros);
  CHECK(together == doctest::Approx(static_cast<double>(alone(grid(20, 20)) + alone(path(7)) +
                                                        alone(grid(30, 5)) + alone(path(1))))
                        .epsilon(0.1));  // random sequences differ
}

TEST_CASE("minimum_degree_under_a_constraint_keeps_the_sequence_of_sets") {
  const CsrGraph graph = random_mesh_graph(12, 12, 3);
  std::vector<std::uint32_t> set_of(vertex_count(graph));
  for (std::uint32_t v = 0; v < set_of.size(); ++v) set_of[v] = v * 7 % 4;
  const auto order = graph::detail::constrained_minimum_degree(graph, set_of);
  CHECK(is_permutation_of_all(graph, order));
  CHECK(std::ranges::is_sorted(order, {}, [&](std::uint32_t v) { return set_of[v]; }));
}

TEST_CASE("minimum_degree_eliminates_trees_and_cliques_as_it_should") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    std::mt19937_64 random(seed);
    Edges edges;
    for (std::uint32_t v = 1; v < 200; ++v) edges.push_back({static_cast<std::uint32_t>(random() % v), v});
    const CsrGraph tree = renamed(graph_from_edges(200, edges).graph, random_order(200, seed));
    CHECK(cholesky_fill(tree, minimum_degree(tree)).fill == 0);
  }
  CHECK(cholesky_fill(complete(30), minimum_degree(complete(30))).fill == 0);
  CHECK(cholesky_fill(cycle(100), minimum_degree(cycle(100))).fill == 97);  // the least possible
}

TEST_CASE("a_stopped_dissection_is_still_an_ordering") {
  std::stop_source source;
  source.request_stop();
  NestedDissectionOptions options;
  options.progress.stop = source.get_token();
  const CsrGraph graph = random_mesh_graph(30, 30, 1);
  const OrderResult found = nested_dissection(graph, options);
  CHECK(found.outcome == OrderOutcome::stopped);
  CHECK(is_permutation_of_all(graph, found.order));
  CHECK_THROWS_AS(static_cast<void>(nested_dissection(graph, {.leaf = 0})), InputError);
  CHECK_THROWS_AS(static_cast<void>(nested_dissection(graph, {.tries = 0})), InputError);
  for (const double side : {0.5, -1.0, 1.5, std::nan("")})
    CHECK_THROWS_AS(static_cast<void>(nested_dissection(graph, {.largest_side = side})), InputError);
}
