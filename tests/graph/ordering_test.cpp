// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering.hpp"

#include "leonhard/graph/boost_graph.hpp"  // before Boost's bandwidth.hpp, which does not include what it uses

#include <doctest/doctest.h>

#include <algorithm>
#include <boost/graph/bandwidth.hpp>
#include <cmath>

#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

/// The cost by its definition, from the dense pattern.
OrderingCost cost_by_brute_force(const CsrGraph& graph, const std::vector<std::uint32_t>& order) {
  const std::uint32_t n = vertex_count(graph);
  const auto entry = [&](std::uint32_t i, std::uint32_t j) {
    return i == j || std::ranges::binary_search(neighbours(graph, order[i]), order[j]);
  };
  std::vector<std::uint32_t> first(n);
  OrderingCost cost;
  for (std::uint32_t i = 0; i < n; ++i) {
    while (!entry(i, first[i])) ++first[i];
    cost.bandwidth = std::max(cost.bandwidth, i - first[i]);
    cost.envelope += i - first[i];
  }
  double squares = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    double active = 0;
    for (std::uint32_t j = i; j < n; ++j) active += first[j] <= i ? 1 : 0;
    squares += active * active;
  }
  cost.rms_wavefront = std::sqrt(squares / n);
  return cost;
}

bool is_permutation(std::vector<std::uint32_t> order, std::uint32_t n) {
  std::ranges::sort(order);
  for (std::uint32_t i = 0; i < order.size(); ++i)
    if (order[i] != i) return false;
  return order.size() == n;
}

}  // namespace

TEST_CASE("reverse_cuthill_mckee_numbers_a_path_from_end_to_end") {
  for (const std::uint32_t n : {1U, 2U, 3U, 50U}) {
    const CsrGraph graph = renamed(path(n), random_order(n, n));
    const OrderingCost cost = ordering_cost(graph, reverse_cuthill_mckee(graph));
    CHECK(cost.bandwidth == (n > 1 ? 1 : 0));
    CHECK(cost.envelope == n - 1);
  }
}

TEST_CASE("reverse_cuthill_mckee_gives_a_grid_its_width_as_bandwidth") {
  // A long grid's optimum is its width (Chvatalova 1975); the diagonal level structure attains it.
  const CsrGraph graph = renamed(grid(6, 40), random_order(240, 9));
  CHECK(ordering_cost(graph, reverse_cuthill_mckee(graph)).bandwidth == 6);
}

TEST_CASE("reverse_cuthill_mckee_is_a_permutation_of_any_graph") {
  for (const CsrGraph& graph :
       {path(0), path(1), complete(9), disjoint_union({path(4), path(1), cycle(5), path(1)}),
        random_mesh_graph(9, 14, 4)}) {
    const auto order = reverse_cuthill_mckee(graph);
    CHECK(is_permutation(order, vertex_count(graph)));
    CHECK(order == reverse_cuthill_mckee(graph));
  }
}

TEST_CASE("reverse_cuthill_mckee_keeps_components_together") {
  const CsrGraph graph =
      renamed(disjoint_union({grid(3, 4), path(6), path(1), cycle(8)}), random_order(27, 1));
  const auto order = reverse_cuthill_mckee(graph);
  const Components parts = components(graph);
  std::uint32_t changes = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    changes += parts.component_of[order[i]] != parts.component_of[order[i - 1]] ? 1 : 0;
  CHECK(changes == 3);
}

TEST_CASE("reverse_cuthill_mckee_halves_the_bandwidth_of_a_shuffled_mesh_many_times") {
  const CsrGraph graph = renamed(random_mesh_graph(30, 30, 8), random_order(961, 8));
  const OrderingCost before = ordering_cost(graph, natural_order(graph));
  const OrderingCost after = ordering_cost(graph, reverse_cuthill_mckee(graph));
  CHECK(before.bandwidth > 900);
  CHECK(after.bandwidth < 80);
  CHECK(after.envelope * 5 < before.envelope);
}

TEST_CASE("reversal_never_enlarges_the_envelope_of_cuthill_mckee") {  // Liu and Sherman 1976
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const CsrGraph graph = random_mesh_graph(12, 9, seed);
    auto order = reverse_cuthill_mckee(graph);
    const OrderingCost reversed = ordering_cost(graph, order);
    std::ranges::reverse(order);
    const OrderingCost forward = ordering_cost(graph, order);
    CHECK(reversed.envelope <= forward.envelope);
    CHECK(reversed.bandwidth == forward.bandwidth);
  }
}

TEST_CASE("ordering_cost_agrees_with_its_definition") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const CsrGraph graph = disjoint_union({random_mesh_graph(6, 5, seed), path(3), path(1)});
    const auto order = random_order(vertex_count(graph), seed);
    const OrderingCost fast = ordering_cost(graph, order), brute = cost_by_brute_force(graph, order);
    CHECK(fast.bandwidth == brute.bandwidth);
    CHECK(fast.envelope == brute.envelope);
    CHECK(fast.rms_wavefront == doctest::Approx(brute.rms_wavefront));
  }
}

TEST_CASE("bandwidth_of_the_natural_order_agrees_with_boost") {
  const CsrGraph graph = renamed(grid(9, 7), random_order(63, 2));
  CHECK(ordering_cost(graph, natural_order(graph)).bandwidth == boost::bandwidth(graph));
}

TEST_CASE("pseudo_peripheral_vertex_of_a_path_is_an_end") {
  for (std::uint32_t start = 0; start < 9; ++start) {
    const std::uint32_t end = pseudo_peripheral_vertex(path(9), start);
    CHECK((end == 0 || end == 8));
  }
  CHECK_THROWS_AS(static_cast<void>(pseudo_peripheral_vertex(path(9), 9)), InputError);
}

TEST_CASE("invert_undoes_an_order_and_refuses_what_is_none") {
  const auto order = random_order(30, 3);
  const auto inverse = invert(order);
  for (std::uint32_t i = 0; i < 30; ++i) CHECK(inverse[order[i]] == i);
  CHECK_THROWS_WITH_AS(static_cast<void>(invert(std::vector<std::uint32_t>{0, 2, 2})),
                       doctest::Contains("number 2 at position 2 is repeated"), InputError);
  CHECK_THROWS_AS(static_cast<void>(invert(std::vector<std::uint32_t>{0, 3, 1})), InputError);
  CHECK_THROWS_AS(static_cast<void>(ordering_cost(path(4), std::vector<std::uint32_t>{0, 1, 2})), InputError);
}
