// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/ordering/by_component.hpp"
#include "leonhard/graph/ordering/combined_levels.hpp"
#include "leonhard/graph/ordering/level_search.hpp"
#include "leonhard/graph/ordering/smallest_envelope.hpp"

namespace leonhard::graph {
namespace {

/// Numbers level after level (algorithm III): first the neighbours of what is numbered in the level before, in its
/// sequence, then the neighbours of what is numbered in the level itself, each by increasing degree.
class LevelNumbering {
 public:
  LevelNumbering(const CsrGraph& graph, const detail::CombinedLevels& levels, detail::StepCounter& steps)
      : graph_(graph),
        level_of_(levels.level_of),
        members_(levels.depth + std::size_t{1}),
        numbered_(levels.level_of.size(), 0),
        steps_(steps) {
    for (const std::uint32_t v : detail::vertices_by_degree(graph)) members_[level_of_[v]].push_back(v);
  }

  [[nodiscard]] std::vector<std::uint32_t> from(std::uint32_t root) {
    number(root);
    std::size_t before = 0, begin = 0;  // where the level before and this one begin in the order
    for (std::uint32_t level = 0; level < members_.size(); ++level) {
      for (std::size_t i = before; i < begin; ++i) number_neighbours(order_[i], level);
      std::size_t next = begin;
      for (const std::uint32_t left : members_[level]) {
        for (; next < order_.size(); ++next) number_neighbours(order_[next], level);
        if (numbered_[left] == 0) number(left);
        if (!steps_.step()) return std::move(order_);
      }
      before = begin;
      begin = order_.size();
    }
    return std::move(order_);
  }

 private:
  void number(std::uint32_t v) {
    numbered_[v] = 1;
    order_.push_back(v);
  }
  void number_neighbours(std::uint32_t v, std::uint32_t level) {
    const std::size_t first = order_.size();
    for (const std::uint32_t w : neighbours(graph_, v))
      if (numbered_[w] == 0 && level_of_[w] == level) number(w);
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(first), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) {
                const std::uint32_t da = degree(graph_, a), db = degree(graph_, b);
                return da != db ? da < db : a < b;
              });
  }

  const CsrGraph& graph_;
  const std::vector<std::uint32_t>& level_of_;
  std::vector<std::vector<std::uint32_t>> members_;  ///< of each level, by degree
  std::vector<char> numbered_;
  std::vector<std::uint32_t> order_;
  detail::StepCounter& steps_;
};

std::vector<std::uint32_t> order_connected(const CsrGraph& graph, detail::StepCounter& steps) {
  const detail::CombinedLevels levels = detail::combined_levels(graph, steps);
  detail::SmallestEnvelope best(graph);
  if (steps.goes_on()) best.offer(LevelNumbering(graph, levels, steps).from(levels.root));
  return best.take();
}

}  // namespace

std::vector<std::uint32_t> gibbs_poole_stockmeyer(const CsrGraph& graph) {
  return gibbs_poole_stockmeyer(graph, Progress{}).order;
}

OrderResult gibbs_poole_stockmeyer(const CsrGraph& graph, const Progress& progress) {
  detail::StepCounter steps(progress, "gibbs-poole-stockmeyer", vertex_count(graph));
  return detail::order_by_component(graph, steps, order_connected);
}

}  // namespace leonhard::graph
