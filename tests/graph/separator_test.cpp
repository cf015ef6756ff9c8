// SPDX-License-Identifier: MIT
#include "leonhard/graph/separator/separator.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <stop_token>
#include <utility>

#include "leonhard/graph/separator/separator_flow.hpp"
#include "leonhard/graph/separator/separator_fm.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::test;

namespace {

/// Checks that no edge joins the sides; returns their sizes and the separator's.
std::array<std::uint32_t, 3> sizes_of(const CsrGraph& graph, const VertexSeparator& found) {
  std::array<std::uint32_t, 3> sizes{};
  REQUIRE(found.side_of.size() == vertex_count(graph));
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) {
    REQUIRE(found.side_of[v] <= VertexSeparator::separator);
    ++sizes[found.side_of[v]];
    for (const std::uint32_t w : neighbours(graph, v)) CHECK(found.side_of[v] + found.side_of[w] != 1);
  }
  CHECK(found.size == sizes[VertexSeparator::separator]);
  return sizes;
}

bool separates(const CsrGraph& graph, const graph::detail::Sides& side) {
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    for (const std::uint32_t w : neighbours(graph, v))
      if (side[v] + side[w] == 1) return false;
  return true;
}

/// Random sides; what of side 1 is next to side 0 is the separator.
graph::detail::Sides random_separator(const CsrGraph& graph, std::mt19937_64& random) {
  graph::detail::Sides side;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    side.push_back(static_cast<std::uint32_t>(random() % 2));
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    if (side[v] == 1 && std::ranges::any_of(neighbours(graph, v), [&](auto w) { return side[w] == 0; }))
      side[v] = graph::detail::middle;
  return side;
}

graph::detail::KwayGraph randomly_weighted(const CsrGraph& graph, std::mt19937_64& random) {
  std::vector<std::uint32_t> weights;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
    weights.push_back(static_cast<std::uint32_t>(1 + random() % 5));
  return graph::detail::weighted_graph(graph, weights, {});
}

}  // namespace

TEST_CASE("a_grid_is_separated_along_its_shorter_side") {
  const CsrGraph graph = renamed(grid(9, 40), random_order(360, 4));
  const auto sizes = sizes_of(graph, vertex_separator(graph, {.largest_side = 0.6, .tries = 8}));
  CHECK(sizes[2] == 9);
  CHECK(std::max(sizes[0], sizes[1]) <= 216);
}

TEST_CASE("separators_keep_the_sides_limit_on_graphs_of_every_kind") {
  for (const CsrGraph& graph :
       {path(2), path(50), cycle(30), star(40), complete(12), random_mesh_graph(30, 20, 3),
        random_graph(60, 20, 1), disjoint_union({grid(8, 8), grid(5, 5), path(9), path(1)})}) {
    const auto sizes = sizes_of(graph, vertex_separator(graph, {.largest_side = 0.67}));
    CHECK(std::max(sizes[0], sizes[1]) <= std::max(1.0, 0.67 * vertex_count(graph)));
  }
  CHECK(vertex_separator(path(0)).side_of.empty());
  CHECK_THROWS_AS(static_cast<void>(vertex_separator(path(3), {.largest_side = 0.5})), InputError);
  CHECK_THROWS_AS(static_cast<void>(vertex_separator(path(3), {.tries = 0})), InputError);
}

TEST_CASE("a_stopped_search_still_gives_a_separator_and_its_size") {
  std::stop_source source;
  source.request_stop();
  SeparatorOptions options;
  options.stop = source.get_token();
  const CsrGraph graph = random_mesh_graph(20, 20, 1);
  CHECK(sizes_of(graph, vertex_separator(graph, options))[2] > 0);
}

TEST_CASE("refined_separators_still_separate_and_are_never_worse") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const CsrGraph graph = seed % 2 == 0 ? random_mesh_graph(9, 8, seed) : random_graph(40, 20, seed);
    const graph::detail::KwayGraph weighted = randomly_weighted(graph, random);
    const std::int64_t limit = weighted.total_weight * 6 / 10;
    graph::detail::Sides side = random_separator(graph, random);
    auto before = graph::detail::quality_of(graph::detail::weights_of(weighted, side), limit);
    const auto reported = graph::detail::SeparatorFm(weighted, limit).refine(side);
    auto after = graph::detail::quality_of(graph::detail::weights_of(weighted, side), limit);
    CHECK(separates(graph, side));
    CHECK(after == reported);
    CHECK(after <= before);
    const bool better = graph::detail::SeparatorFlow(weighted, limit).improve(side, 3);
    before = std::exchange(after, graph::detail::quality_of(graph::detail::weights_of(weighted, side), limit));
    CHECK(separates(graph, side));
    CHECK(better == (after < before));
    CHECK(after <= before);
  }
}

TEST_CASE("a_flow_straightens_a_separator_at_once") {
  const std::uint32_t width = 9, height = 80;
  const CsrGraph graph = grid(width, height);
  graph::detail::Sides side(width * height);
  for (std::uint32_t j = 0; j < height; ++j)  // a slope of two rows a column: 17 vertices
    for (std::uint32_t i = 0; i < width; ++i) {
      const std::uint32_t last = 30 + 2 * i;
      const std::uint32_t thick = i + 1 < width ? 2 : 1;
      side[j * width + i] = j < last ? 0 : j < last + thick ? graph::detail::middle : 1;
    }
  REQUIRE(separates(graph, side));
  const graph::detail::KwayGraph weighted = graph::detail::weighted_graph(graph, {}, {});
  REQUIRE(graph::detail::weights_of(weighted, side)[graph::detail::middle] == 17);
  CHECK(graph::detail::SeparatorFlow(weighted, 460).improve(side, 20));
  CHECK(separates(graph, side));
  CHECK(graph::detail::weights_of(weighted, side)[graph::detail::middle] == width);
}

TEST_CASE("a_flow_finds_the_lightest_vertex_of_a_path") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    const std::uint32_t n = 30;
    std::vector<std::uint32_t> weights;
    for (std::uint32_t v = 0; v < n; ++v) weights.push_back(static_cast<std::uint32_t>(5 + random() % 50));
    weights[0] = weights[n - 1] = 100;  // an end separates nothing
    const graph::detail::KwayGraph weighted = graph::detail::weighted_graph(path(n), weights, {});
    graph::detail::Sides side(n, 0);
    side[n / 2] = graph::detail::middle;
    std::fill(side.begin() + n / 2 + 1, side.end(), 1);
    graph::detail::SeparatorFlow(weighted, weighted.total_weight).improve(side, 1000);
    CHECK(separates(path(n), side));
    CHECK(graph::detail::weights_of(weighted, side)[graph::detail::middle] == *std::ranges::min_element(weights));
  }
}

TEST_CASE("the_partitioner_s_graphs_know_their_components") {
  const CsrGraph graph = disjoint_union({path(3), cycle(5), path(1), star(4)});
  const graph::detail::KwayComponents found = graph::detail::components(graph::detail::weighted_graph(graph, {}, {}));
  CHECK(found.count == 4);
  CHECK(found.component_of == std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1, 1, 1, 2, 3, 3, 3, 3});
}
