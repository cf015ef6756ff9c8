// SPDX-License-Identifier: MIT
#include "leonhard/graph/separator/multilevel_separator.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/graph/multilevel/kway_coarsen.hpp"
#include "leonhard/graph/separator/separator_flow.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph::detail {
namespace {

/// A side grown breadth first from a vertex until it weighs half, what is next to it as separator.
Sides grown(const KwayGraph& graph, std::uint32_t root) {
  Sides side(graph.size(), 1);
  std::vector<char> seen(graph.size(), 0);
  std::vector<std::uint32_t> queue;
  queue.reserve(graph.size());
  std::int64_t weight = 0;
  for (std::uint32_t i = 0; i < graph.size() && 2 * weight < graph.total_weight; ++i) {
    for (; i == queue.size(); root = (root + 1) % graph.size())  // another component
      if (!std::exchange(seen[root], char{1})) queue.push_back(root);
    side[queue[i]] = 0;
    weight += graph.vertex_weight[queue[i]];
    for (const Arc& arc : graph.row(queue[i]))
      if (!std::exchange(seen[arc.to], char{1})) queue.push_back(arc.to);
  }
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    if (side[v] == 1 && std::ranges::any_of(graph.row(v), [&](const Arc& arc) { return side[arc.to] == 0; }))
      side[v] = middle;
  return side;
}

FoundSeparator best_grown(const KwayGraph& graph, std::int64_t limit, Random& random,
                          const std::stop_token& stop) {
  SeparatorFm fm(graph, limit);
  FoundSeparator best;
  constexpr int roots = 8;
  for (int i = 0; i < roots; ++i) {
    if (i > 0 && stop.stop_requested()) break;
    FoundSeparator found{grown(graph, random.below(graph.size())), {}};
    found.quality =
        stop.stop_requested() ? quality_of(weights_of(graph, found.side), limit) : fm.refine(found.side);
    if (i == 0 || found.quality < best.quality) best = std::move(found);
  }
  return best;
}

void refine(const KwayGraph& graph, std::int64_t limit, FoundSeparator& found) {
  constexpr std::int64_t depth = 16;
  found.quality = SeparatorFm(graph, limit).refine(found.side);
  if (SeparatorFlow(graph, limit).improve(found.side, depth))
    found.quality = quality_of(weights_of(graph, found.side), limit);
}

/// From the coarsest level to the finest; after a stop request without refinement.
void rise(const Hierarchy& levels, std::int64_t limit, FoundSeparator& found, const std::stop_token& stop) {
  for (std::size_t depth = levels.levels() - 1; depth-- > 0;) {
    found.side = levels.project(depth, found.side);
    if (!stop.stop_requested()) refine(levels.level(depth), limit, found);
  }
}

FoundSeparator descend_and_rise(const KwayGraph& graph, std::int64_t limit, Random& random,
                                const std::stop_token& stop) {
  constexpr std::uint32_t coarsest = 60;
  const Hierarchy levels(graph, coarsest, {}, random, stop);
  FoundSeparator found = best_grown(levels.coarsest(), limit, random, stop);
  rise(levels, limit, found, stop);
  return found;
}

}  // namespace

void check_separator_options(double largest_side, std::uint32_t tries) {
  if (!(largest_side > 0.5) || largest_side > 1 || tries == 0)
    throw InputError("options",
                     "largest side " + std::to_string(largest_side) + ", " + std::to_string(tries) + " tries",
                     "give a side in (1/2, 1] and at least one try");
}

FoundSeparator multilevel_separator(const KwayGraph& graph, double largest_side, std::uint32_t tries,
                                    Random& random, const std::stop_token& stop) {
  const auto limit = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(largest_side * static_cast<double>(graph.total_weight)));
  constexpr std::uint32_t size_for_tries = 3000;
  const Hierarchy trunk(graph, size_for_tries, {}, random, stop);
  FoundSeparator best;
  for (std::uint32_t i = 0; i < tries; ++i) {
    if (i > 0 && stop.stop_requested()) break;
    FoundSeparator found = descend_and_rise(trunk.coarsest(), limit, random, stop);
    if (i == 0 || found.quality < best.quality) best = std::move(found);
  }
  rise(trunk, limit, best, stop);
  return best;
}

}  // namespace leonhard::graph::detail
