// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/kway_bisect.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "leonhard/graph/multilevel/gain_queue.hpp"
#include "leonhard/graph/multilevel/kway_coarsen.hpp"
#include "leonhard/graph/multilevel/two_way_fm.hpp"
#include "leonhard/graph/partition/kway_flow.hpp"

namespace leonhard::graph::detail {
namespace {

constexpr std::uint32_t passes = 8;  ///< of FM at most

/// Side 0 grows from a random vertex by largest gain until it has its weight; a new random vertex where a component
/// ends.
std::vector<std::uint32_t> grow(const KwayGraph& graph, const BisectionGoal& goal, GainQueue& queue,
                                Random& random) {
  std::vector<std::uint32_t> side(graph.size(), 1);
  std::vector<char> refused(graph.size(), 0);
  const std::vector<std::uint32_t> seeds = random.permutation(graph.size());
  auto seed = seeds.begin();
  std::int64_t weight = 0;
  queue.clear();
  while (weight < goal.target[0]) {
    if (queue.empty()) {
      while (seed != seeds.end() && (side[*seed] == 0 || refused[*seed])) ++seed;
      if (seed == seeds.end()) break;
      queue.set(*seed, 0);
    }
    const std::uint32_t v = queue.pop();
    if (weight + graph.vertex_weight[v] > goal.limit[0]) {
      refused[v] = 1;
      continue;
    }
    side[v] = 0;
    weight += graph.vertex_weight[v];
    for (const Arc& arc : graph.row(v)) {
      const std::uint32_t u = arc.to;
      if (side[u] == 0 || refused[u]) continue;
      if (queue.contains(u)) {
        queue.set(u, queue.gain(u) + 2 * arc.weight);
        continue;
      }
      std::int32_t gain = 0;
      for (const Arc& back : graph.row(u)) gain += side[back.to] == 0 ? back.weight : -back.weight;
      queue.set(u, gain);
    }
  }
  queue.clear();
  return side;
}

/// The first vertices that are heavy enough together to side 0: what there is time for after a stop request.
std::vector<std::uint32_t> by_index(const KwayGraph& graph, const BisectionGoal& goal) {
  std::vector<std::uint32_t> side(graph.size(), 1);
  std::int64_t weight = 0;
  for (std::uint32_t v = 0; v < graph.size() && weight < goal.target[0]; ++v) {
    side[v] = 0;
    weight += graph.vertex_weight[v];
  }
  return side;
}

/// A bisection and what it is worth: less is better, first in excess over the limits.
struct Bisection {
  std::vector<std::uint32_t> side;
  std::int64_t excess = std::numeric_limits<std::int64_t>::max();
  std::int64_t cut = 0;

  [[nodiscard]] bool operator<(const Bisection& other) const {
    return std::pair(excess, cut) < std::pair(other.excess, other.cut);
  }
};

Bisection best_grown(const KwayGraph& graph, const BisectionGoal& goal, std::uint32_t tries, Random& random) {
  TwoWayFm fm(graph, goal);
  GainQueue queue(graph.size());
  Bisection best;
  for (std::uint32_t i = 0; i < tries; ++i) {
    Bisection grown;
    grown.side = grow(graph, goal, queue, random);
    grown.cut = fm.refine(grown.side, passes);
    grown.excess = fm.excess();
    if (grown < best) best = std::move(grown);
  }
  return best;
}

void refine(const KwayGraph& graph, const BisectionGoal& goal, Bisection& bisection, Random& random,
            const std::stop_token& stop) {
  TwoWayFm fm(graph, goal);
  bisection.cut = fm.refine(bisection.side, passes);
  bisection.excess = fm.excess();
  if (bisection.excess > 0 || bisection.cut == 0) return;
  constexpr KwayFlow::Strip strip{4, 100};
  KwayFlow flow(graph, {{goal.target[0], goal.limit[0]}, {goal.target[1], goal.limit[1]}}, bisection.side,
                random);
  bisection.cut -= flow.round(strip, stop);
}

Bisection descend_and_rise(const KwayGraph& graph, const BisectionGoal& goal,
                           const BisectionSettings& settings, Random& random, const std::stop_token& stop) {
  const Hierarchy levels(graph, settings.coarsest, {}, random, stop);
  const auto goal_at = [&](std::size_t depth) {
    BisectionGoal relaxed = goal;
    if (depth > 0)
      for (std::int64_t& limit : relaxed.limit) limit += allowance(levels.level(depth));
    return relaxed;
  };
  Bisection found = best_grown(levels.coarsest(), goal_at(levels.levels() - 1), settings.tries, random);
  for (std::size_t depth = levels.levels(); depth-- > 0;) {
    if (depth + 1 < levels.levels()) found.side = levels.project(depth, found.side);
    if (!stop.stop_requested()) refine(levels.level(depth), goal_at(depth), found, random, stop);
  }
  return found;
}

}  // namespace

std::vector<std::uint32_t> multilevel_bisection(const KwayGraph& graph, const BisectionGoal& goal,
                                                const BisectionSettings& settings, Random& random,
                                                const std::stop_token& stop) {
  if (stop.stop_requested()) return by_index(graph, goal);
  Bisection best;
  for (std::uint32_t i = 0; i < settings.repeats; ++i) {
    if (i > 0 && stop.stop_requested()) break;
    Bisection found = descend_and_rise(graph, goal, settings, random, stop);
    if (found < best) best = std::move(found);
  }
  return std::move(best.side);
}

}  // namespace leonhard::graph::detail
