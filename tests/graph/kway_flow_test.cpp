// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/kway_flow.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <stop_token>

#include "tests/graph/graphs.hpp"

using namespace leonhard::graph;
using namespace leonhard::graph::detail;
using namespace leonhard::graph::test;

namespace {

std::vector<KwayFlow::Room> rooms(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit) {
  return std::vector<KwayFlow::Room>(parts, {graph.total_weight / parts, limit});
}

}  // namespace

TEST_CASE("a_flow_straightens_the_boundary_of_two_parts_at_once") {
  const std::uint32_t size = 20;
  const KwayGraph graph = weighted_graph(grid(size, size), {}, {});
  std::vector<std::uint32_t> part_of;
  for (std::uint32_t j = 0; j < size; ++j)  // teeth of five rows
    for (std::uint32_t i = 0; i < size; ++i) part_of.push_back(i < 8 + j % 5 ? 0 : 1);
  const std::int64_t before = cut_of(graph, part_of);
  REQUIRE(before == 48);
  Random random(1);
  KwayFlow flow(graph, rooms(graph, 2, 240), part_of, random);
  CHECK(flow.round({4, 6}, {}) == before - size);
  CHECK(cut_of(graph, part_of) == size);
  CHECK(flow.round({4, 6}, {}) == 0);
}

TEST_CASE("flows_keep_the_limit_and_tell_by_how_much_the_cut_became_less") {
  int better = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const CsrGraph plain = random_mesh_graph(12, 11, seed);
    Random random(seed);
    std::vector<std::uint32_t> weights;
    for (std::uint32_t v = 0; v < vertex_count(plain); ++v) weights.push_back(1 + random.below(4));
    const KwayGraph graph = weighted_graph(plain, weights, {});
    std::vector<std::uint32_t> part_of;
    for (std::uint32_t v = 0; v < graph.size(); ++v) part_of.push_back(random.below(3));
    const auto heaviest = [&] { return std::ranges::max(part_weights(graph, part_of, 3)); };
    const std::int64_t limit = heaviest() + 5, before = cut_of(graph, part_of);
    KwayFlow flow(graph, rooms(graph, 3, limit), part_of, random);
    const std::int64_t gained = flow.round({3, 6}, {});
    better += gained > 0 ? 1 : 0;
    CHECK(cut_of(graph, part_of) == before - gained);
    CHECK(heaviest() <= limit);
  }
  CHECK(better > 25);  // sides so ragged are hardly ever the best
}

TEST_CASE("a_stopped_flow_changes_nothing") {
  const KwayGraph graph = weighted_graph(grid(6, 6), {}, {});
  std::vector<std::uint32_t> part_of;
  for (std::uint32_t v = 0; v < 36; ++v) part_of.push_back(v % 2);
  const std::vector<std::uint32_t> as_given = part_of;
  std::stop_source source;
  source.request_stop();
  Random random(1);
  CHECK(KwayFlow(graph, rooms(graph, 2, 20), part_of, random).round({4, 6}, source.get_token()) == 0);
  CHECK(part_of == as_given);
}
