// SPDX-License-Identifier: MIT
#include "leonhard/graph/fill.hpp"

#include <doctest/doctest.h>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

/// Column counts and first subdiagonal rows of L by eliminating the dense pattern.
struct Eliminated {
  std::vector<std::uint32_t> column_count, parent;
};

Eliminated eliminate(const CsrGraph& graph, const std::vector<std::uint32_t>& order) {
  const std::uint32_t n = vertex_count(graph);
  const auto new_of_old = invert(order);
  std::vector<std::vector<bool>> entry(n, std::vector<bool>(n, false));
  for (std::uint32_t i = 0; i < n; ++i) {
    entry[i][i] = true;
    for (const std::uint32_t w : neighbours(graph, order[i])) entry[i][new_of_old[w]] = true;
  }
  Eliminated result{std::vector<std::uint32_t>(n, 0), std::vector<std::uint32_t>(n, no_parent)};
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t i = k; i < n; ++i) {
      if (!entry[i][k]) continue;
      ++result.column_count[k];
      if (i > k && result.parent[k] == no_parent) result.parent[k] = i;
      for (std::uint32_t j = k + 1; j < n; ++j)
        if (entry[j][k]) entry[i][j] = true;
    }
  return result;
}

}  // namespace

TEST_CASE("column_counts_and_tree_agree_with_dense_elimination") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const CsrGraph graph = disjoint_union({random_mesh_graph(7, 5, seed), cycle(6), path(1), path(4)});
    for (const auto& order :
         {random_order(vertex_count(graph), seed), natural_order(graph), reverse_cuthill_mckee(graph)}) {
      const Eliminated dense = eliminate(graph, order);
      const CholeskyFill fill = cholesky_fill(graph, order);
      CHECK(fill.column_count == dense.column_count);
      CHECK(elimination_tree(graph, order) == dense.parent);
      std::uint64_t nonzeros = 0;
      for (const std::uint32_t count : dense.column_count) nonzeros += count;
      CHECK(fill.nonzeros == nonzeros);
      CHECK(fill.fill == nonzeros - vertex_count(graph) - edge_count(graph));
    }
  }
}

TEST_CASE("a_tree_eliminated_from_its_leaves_fills_nothing") {
  CHECK(cholesky_fill(path(40), natural_order(path(40))).fill == 0);
}

TEST_CASE("a_complete_graph_has_nothing_to_fill") {
  const CholeskyFill fill = cholesky_fill(complete(12), random_order(12, 1));
  CHECK(fill.fill == 0);
  CHECK(fill.nonzeros == 78);
  CHECK(fill.flops == 650);  // 1 + 4 + ... + 144
}

TEST_CASE("a_cycle_fills_n_minus_3_in_any_order") {  // each elimination leaves a cycle one vertex shorter
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    CHECK(cholesky_fill(cycle(20), random_order(20, seed)).fill == 17);
}

TEST_CASE("fill_stays_within_the_envelope") {
  const CsrGraph graph = random_mesh_graph(15, 15, 3);
  const auto order = reverse_cuthill_mckee(graph);
  CHECK(cholesky_fill(graph, order).nonzeros <= ordering_cost(graph, order).envelope + vertex_count(graph));
}

TEST_CASE("cholesky_fill_refuses_what_is_no_permutation") {
  CHECK_THROWS_AS(static_cast<void>(cholesky_fill(path(3), std::vector<std::uint32_t>{0, 1})), InputError);
  CHECK_THROWS_AS(static_cast<void>(elimination_tree(path(3), std::vector<std::uint32_t>{0, 1, 1})),
                  InputError);
}
