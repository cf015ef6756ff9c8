// SPDX-License-Identifier: MIT
// Level structures, the ends of graphs and what is combined of two, against their definitions.
#include "leonhard/graph/ordering/level_search.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/ordering/combined_levels.hpp"
#include "leonhard/graph/support/step_counter.hpp"
#include "tests/graph/graphs.hpp"

using namespace leonhard;
using namespace leonhard::graph;
using namespace leonhard::graph::detail;
using namespace leonhard::graph::test;

namespace {

using Levels = std::vector<std::uint32_t>;

Levels levels_from(const CsrGraph& graph, std::uint32_t root) {
  Levels level(vertex_count(graph), vertex_count(graph));
  std::vector<std::uint32_t> queue{root};
  level[root] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (const std::uint32_t w : neighbours(graph, queue[i]))
      if (level[w] == vertex_count(graph)) {
        level[w] = level[queue[i]] + 1;
        queue.push_back(w);
      }
  return level;
}

std::uint32_t width(const Levels& level) {
  std::map<std::uint32_t, std::uint32_t> size;
  for (const std::uint32_t l : level) ++size[l];
  return std::ranges::max_element(size, {}, [](const auto& entry) { return entry.second; })->second;
}

/// Strips, some with a leaf in their middle and one at their end, and meshes, under names that tell nothing.
std::vector<CsrGraph> long_graphs() {
  std::vector<CsrGraph> graphs;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    graphs.push_back(renamed(random_mesh_graph(5, 19, seed), random_order(120, seed)));
  for (std::uint32_t leaf = 3; leaf < 27; leaf += 2) {
    Edges edges{{90, 3 * leaf}, {91, 0}};  // the leaf beside the strip has the smaller number
    const CsrGraph strip = grid(3, 30);
    for (std::uint32_t v = 0; v < 90; ++v)
      for (const std::uint32_t w : neighbours(strip, v)) edges.push_back({v, w});
    graphs.push_back(graph_from_edges(92, edges).graph);
  }
  return graphs;
}

/// Algorithm II of Gibbs, Poole and Stockmeyer, word by word.
Levels combined_by_definition(const CsrGraph& graph, const PseudoDiameter& ends) {
  const std::uint32_t n = vertex_count(graph);
  std::array<Levels, 2> level{levels_from(graph, ends.from), levels_from(graph, ends.to)};
  const std::array<std::uint32_t, 2> widths{width(level[0]), width(level[1])};
  for (std::uint32_t& l : level[1]) l = ends.depth - l;
  std::vector<std::uint32_t> size(ends.depth + 1, 0);
  Edges undecided;
  for (std::uint32_t v = 0; v < n; ++v) {
    if (level[0][v] == level[1][v]) ++size[level[0][v]];
    for (const std::uint32_t w : neighbours(graph, v))
      if (level[0][v] != level[1][v] && level[0][w] != level[1][w]) undecided.push_back({v, w});
  }
  const Components groups = components(graph_from_edges(n, undecided).graph);
  std::vector<std::uint32_t> sequence(groups.count());
  for (std::uint32_t g = 0; g < sequence.size(); ++g) sequence[g] = g;
  std::ranges::stable_sort(sequence, std::ranges::greater{},
                           [&](std::uint32_t g) { return groups.sizes[g]; });
  Levels result = level[0];
  for (const std::uint32_t g : sequence) {
    std::array<std::uint32_t, 2> widest{0, 0};
    std::array<std::vector<std::uint32_t>, 2> after{size, size};
    bool any = false;
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::uint32_t v = 0; v < n; ++v)
        if (groups.component_of[v] == g && level[0][v] != level[1][v]) {
          ++after[k][level[k][v]];
          any = true;
        }
      for (std::uint32_t l = 0; l <= ends.depth; ++l)
        if (after[k][l] > size[l]) widest[k] = std::max(widest[k], after[k][l]);
    }
    if (!any) continue;
    const std::size_t choice =
        widest[0] != widest[1] ? (widest[1] < widest[0] ? 1 : 0) : (widths[1] < widths[0] ? 1 : 0);
    size = after[choice];
    for (std::uint32_t v = 0; v < n; ++v)
      if (groups.component_of[v] == g) result[v] = level[choice][v];
  }
  return result;
}

const Progress nothing;

}  // namespace

TEST_CASE("a_pseudo_peripheral_vertex_is_sought_as_long_as_levels_get_deeper") {
  std::uint32_t most_steps = 0;
  for (std::uint64_t seed = 1; seed < 40; ++seed) {
    const CsrGraph graph = renamed(random_mesh_graph(6, 9, seed), random_order(70, seed));
    const auto eccentricity = [&](std::uint32_t v) { return std::ranges::max(levels_from(graph, v)); };
    for (const std::uint32_t start : {0U, 33U}) {
      std::uint32_t at = start, steps = 0;
      for (bool deeper = true; deeper; ++steps) {
        const Levels level = levels_from(graph, at);
        std::uint32_t next = at;
        for (std::uint32_t v = 70; v-- > 0;)
          if (level[v] == eccentricity(at) && (next == at || degree(graph, v) <= degree(graph, next)))
            next = v;
        deeper = eccentricity(next) > eccentricity(at);
        at = next;
      }
      most_steps = std::max(most_steps, steps);
      CHECK(pseudo_peripheral_vertex(graph, start) == at);
    }
  }
  CHECK(most_steps > 2);
}

TEST_CASE("reverse_cuthill_mckee_starts_at_an_end_even_if_the_least_degree_is_elsewhere") {
  Edges edges{{90, 45}};  // a leaf amid a strip
  const CsrGraph strip = grid(3, 30);
  for (std::uint32_t v = 0; v < 90; ++v)
    for (const std::uint32_t w : neighbours(strip, v)) edges.push_back({v, w});
  const CsrGraph graph = graph_from_edges(91, edges).graph;
  CHECK(ordering_cost(graph, reverse_cuthill_mckee(graph)).bandwidth <= 5);
  CHECK(ordering_cost(graph, cuthill_mckee(graph)).bandwidth >= 6);
}

TEST_CASE("the_other_end_is_the_one_with_the_narrowest_levels") {
  for (const CsrGraph& graph : long_graphs()) {
    LevelSearch search(graph);
    StepCounter steps(nothing, "", 1);
    const PseudoDiameter ends = pseudo_diameter(graph, search, vertices_by_degree(graph).front(), steps);
    const Levels level = levels_from(graph, ends.from);
    CHECK(level[ends.to] == ends.depth);
    CHECK(std::ranges::max(level) == ends.depth);
    std::map<std::uint32_t, std::uint32_t> candidates;  // by degree the first of the last level
    for (std::uint32_t v = 0; v < vertex_count(graph); ++v)
      if (level[v] == ends.depth) candidates.emplace(degree(graph, v), v);
    for (const auto& [degree, v] : candidates) {
      CHECK(std::ranges::max(levels_from(graph, v)) <= ends.depth);
      CHECK(width(levels_from(graph, ends.to)) <= width(levels_from(graph, v)));
    }
    CHECK(search(ends.to) == ends.depth);
    CHECK(search.width() == width(levels_from(graph, ends.to)));
  }
}

TEST_CASE("levels_of_both_ends_are_combined_as_gibbs_poole_and_stockmeyer_say") {
  std::size_t reversed = 0, mixed = 0;
  for (const CsrGraph& graph : long_graphs()) {
    LevelSearch search(graph);
    StepCounter steps(nothing, "", 1);
    const PseudoDiameter ends = pseudo_diameter(graph, search, vertices_by_degree(graph).front(), steps);
    Levels expected = combined_by_definition(graph, ends);
    mixed += expected != levels_from(graph, ends.from) ? 1U : 0U;
    std::uint32_t root = ends.from;
    if (degree(graph, ends.to) < degree(graph, ends.from)) {
      for (std::uint32_t& level : expected) level = ends.depth - level;
      root = ends.to;
      ++reversed;
    }
    const CombinedLevels found = combined_levels(graph, steps);
    CHECK(found.root == root);
    CHECK(found.depth == ends.depth);
    CHECK(found.level_of == expected);
  }
  CHECK(reversed > 0);
  CHECK(mixed > 3);
}

TEST_CASE("steps_are_reported_now_and_then_and_a_stop_once_seen_stays") {
  std::stop_source source;
  std::vector<double> fractions;
  const Progress progress{[&](std::string_view stage, double fraction) {
                            CHECK(stage == "walk");
                            fractions.push_back(fraction);
                          },
                          source.get_token()};
  StepCounter steps(progress, "walk", 5000);
  for (int i = 0; i < 10000; ++i) CHECK(steps.step());  // more than expected
  CHECK(fractions.size() == 1 + 10000 / 2048);
  CHECK(fractions.front() == 0);
  CHECK(fractions[1] == 2048 / 5000.0);
  CHECK(fractions.back() == 1);
  CHECK(steps.goes_on());
  source.request_stop();
  CHECK_FALSE(steps.stopped());  // nobody has asked yet
  CHECK_FALSE(steps.goes_on());
  CHECK(steps.stopped());
  CHECK_FALSE(steps.step());
  CHECK_FALSE(StepCounter(progress, "walk", 0).step());
}
