// SPDX-License-Identifier: MIT
#include "leonhard/graph/separator_graph.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace leonhard::graph::detail {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::vector<std::uint32_t> random_sequence(std::uint32_t n, std::mt19937_64& random) {
  std::vector<std::uint32_t> sequence(n);
  std::iota(sequence.begin(), sequence.end(), 0U);
  for (std::size_t i = n; i > 1; --i) std::swap(sequence[i - 1], sequence[random() % i]);
  return sequence;
}

class Matching {
 public:
  Matching(const SeparatorGraph& graph, std::uint32_t largest)
      : graph_(graph), largest_(largest), partner_(graph.size(), none) {}

  std::vector<std::uint32_t> match(std::mt19937_64& random) {
    for (const std::uint32_t v : random_sequence(graph_.size(), random)) {
      if (partner_[v] != none) continue;
      std::uint32_t partner = heaviest_neighbour(v);
      if (partner == none) partner = someone_beside(v);
      if (partner == none) partner = v;
      partner_[v] = partner;
      partner_[partner] = v;
    }
    return std::move(partner_);
  }

 private:
  [[nodiscard]] bool may_join(std::uint32_t v, std::uint32_t w) const {
    return w != v && partner_[w] == none && graph_.weight[v] + graph_.weight[w] <= largest_;
  }
  /// Among equal edges the lightest neighbour, which keeps the coarse vertices of one size.
  [[nodiscard]] std::uint32_t heaviest_neighbour(std::uint32_t v) const {
    std::uint32_t best = none, best_weight = 0;
    for (const auto& [w, weight] : graph_.row(v)) {
      if (!may_join(v, w) || weight < best_weight) continue;
      if (weight == best_weight && graph_.weight[w] >= graph_.weight[best]) continue;
      best = w;
      best_weight = weight;
    }
    return best;
  }
  [[nodiscard]] std::uint32_t someone_beside(std::uint32_t v) const {
    constexpr std::size_t enough = 32;  // a hub has neighbours without end
    for (const auto& [w, unused] : graph_.row(v).first(std::min(graph_.row(v).size(), enough)))
      for (const auto& [x, unused_too] : graph_.row(w).first(std::min(graph_.row(w).size(), enough)))
        if (may_join(v, x)) return x;
    return none;
  }

  const SeparatorGraph& graph_;
  std::uint32_t largest_;
  std::vector<std::uint32_t> partner_;
};

}  // namespace

SeparatorGraph separator_graph(const CsrGraph& graph) {
  SeparatorGraph result;
  result.total = vertex_count(graph);
  result.weight.assign(result.total, 1);
  result.start.reserve(result.total + std::size_t{1});
  result.arcs.reserve(2 * edge_count(graph));
  for (std::uint32_t v = 0; v < result.total; ++v) {
    for (const std::uint32_t w : neighbours(graph, v)) result.arcs.push_back({w, 1});
    result.start.push_back(static_cast<std::uint32_t>(result.arcs.size()));
  }
  return result;
}

Coarsening coarsen(const SeparatorGraph& graph, std::uint32_t largest, std::mt19937_64& random) {
  const std::vector<std::uint32_t> partner = Matching(graph, largest).match(random);
  Coarsening result;
  result.coarse_of.assign(graph.size(), none);
  std::vector<std::uint32_t> first;  // of each coarse vertex
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    if (result.coarse_of[v] != none) continue;
    result.coarse_of[v] = result.coarse_of[partner[v]] = static_cast<std::uint32_t>(first.size());
    first.push_back(v);
    result.graph.weight.push_back(graph.weight[v] + (partner[v] == v ? 0 : graph.weight[partner[v]]));
  }
  result.graph.total = graph.total;
  std::vector<std::uint32_t> place(first.size(), none);  // of a coarse neighbour among the row's arcs
  for (std::uint32_t coarse = 0; coarse < first.size(); ++coarse) {
    const std::uint32_t row = result.graph.start.back(), v = first[coarse];
    const auto add_row = [&](std::uint32_t fine) {
      for (const auto& [w, weight] : graph.row(fine)) {
        const std::uint32_t to = result.coarse_of[w];
        if (to == coarse) continue;
        if (place[to] == none || place[to] < row) {
          place[to] = static_cast<std::uint32_t>(result.graph.arcs.size());
          result.graph.arcs.push_back({to, 0});
        }
        result.graph.arcs[place[to]].weight += weight;
      }
    };
    add_row(v);
    if (partner[v] != v) add_row(partner[v]);
    result.graph.start.push_back(static_cast<std::uint32_t>(result.graph.arcs.size()));
  }
  return result;
}

}  // namespace leonhard::graph::detail
