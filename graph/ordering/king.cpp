// SPDX-License-Identifier: MIT
#include <utility>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/ordering/by_component.hpp"
#include "leonhard/graph/ordering/combined_levels.hpp"
#include "leonhard/graph/ordering/king_numbering.hpp"
#include "leonhard/graph/ordering/level_search.hpp"
#include "leonhard/graph/ordering/smallest_envelope.hpp"

namespace leonhard::graph {
namespace {

std::vector<std::uint32_t> from_both_ends(const CsrGraph& graph, detail::StepCounter& steps) {
  detail::LevelSearch search(graph);
  const detail::PseudoDiameter ends =
      detail::pseudo_diameter(graph, search, detail::vertices_by_degree(graph).front(), steps);
  detail::SmallestEnvelope best(graph);
  for (const std::uint32_t root : {ends.from, ends.to})
    if (steps.goes_on()) best.offer(detail::king_numbering(graph, root, {}, steps));
  return best.take();
}

std::vector<std::uint32_t> by_levels(const CsrGraph& graph, detail::StepCounter& steps) {
  const detail::CombinedLevels levels = detail::combined_levels(graph, steps);
  detail::SmallestEnvelope best(graph);
  if (steps.goes_on()) best.offer(detail::king_numbering(graph, levels.root, levels.level_of, steps));
  return best.take();
}

}  // namespace

std::vector<std::uint32_t> king(const CsrGraph& graph) { return king(graph, Progress{}).order; }

OrderResult king(const CsrGraph& graph, const Progress& progress) {
  detail::StepCounter steps(progress, "king", std::size_t{2} * vertex_count(graph));
  return detail::order_by_component(graph, steps, from_both_ends);
}

std::vector<std::uint32_t> gibbs_king(const CsrGraph& graph) { return gibbs_king(graph, Progress{}).order; }

OrderResult gibbs_king(const CsrGraph& graph, const Progress& progress) {
  detail::StepCounter steps(progress, "gibbs-king", vertex_count(graph));
  return detail::order_by_component(graph, steps, by_levels);
}

}  // namespace leonhard::graph
