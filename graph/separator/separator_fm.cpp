// SPDX-License-Identifier: MIT
#include "leonhard/graph/separator/separator_fm.hpp"

#include <algorithm>

namespace leonhard::graph::detail {

SideWeights weights_of(const KwayGraph& graph, const Sides& side) {
  SideWeights weight{};
  for (std::uint32_t v = 0; v < graph.size(); ++v) weight[side[v]] += graph.vertex_weight[v];
  return weight;
}

SeparatorQuality quality_of(const SideWeights& weight, std::int64_t limit) {
  const auto [smaller, larger] = std::minmax(weight[0], weight[1]);
  return {std::max<std::int64_t>(0, larger - limit), weight[middle], larger - smaller};
}

SeparatorFm::SeparatorFm(const KwayGraph& graph, std::int64_t limit)
    : graph_(graph),
      limit_(limit),
      queue_{GainQueue(graph.size()), GainQueue(graph.size())},
      moved_(graph.size(), 0) {}

SeparatorQuality SeparatorFm::refine(Sides& side) {
  side_ = &side;
  weight_ = weights_of(graph_, side);
  constexpr int passes = 8;
  for (int i = 0; i < passes && pass(); ++i) {
  }
  return quality_of(weight_, limit_);
}

void SeparatorFm::put(std::uint32_t v, std::uint32_t to) {
  std::uint32_t& side = (*side_)[v];
  weight_[side] -= graph_.vertex_weight[v];
  weight_[to] += graph_.vertex_weight[v];
  side = to;
}

/// Into the queues, unless it moved in this pass.
void SeparatorFm::file(std::uint32_t v) {
  if (moved_[v]) return;
  std::array<std::int32_t, 2> gain{graph_.vertex_weight[v], graph_.vertex_weight[v]};
  for (const Arc& arc : graph_.row(v))
    if (const std::uint32_t side = (*side_)[arc.to]; side != middle)
      gain[1 - side] -= graph_.vertex_weight[arc.to];
  queue_[0].set(v, gain[0]);
  queue_[1].set(v, gain[1]);
}

/// Where to move to: where the gain is larger, if there is room; -1: nowhere.
int SeparatorFm::next_side() const {
  const auto possible = [&](std::uint32_t to) {
    return !queue_[to].empty() &&
           (weight_[to] + graph_.vertex_weight[queue_[to].top()] <= limit_ || weight_[to] < weight_[1 - to]);
  };
  if (!possible(0) || !possible(1)) return possible(0) ? 0 : possible(1) ? 1 : -1;
  const std::int32_t first = queue_[0].top_gain(), second = queue_[1].top_gain();
  if (first != second) return first > second ? 0 : 1;
  return weight_[0] <= weight_[1] ? 0 : 1;
}

void SeparatorFm::move(std::uint32_t to) {
  const std::uint32_t v = queue_[to].pop(), other = 1 - to;
  queue_[other].remove(v);
  moved_[v] = 1;
  changes_.push_back({v, middle});
  put(v, to);
  for (const Arc& arc : graph_.row(v)) {
    if (queue_[other].contains(arc.to))
      queue_[other].set(arc.to, queue_[other].gain(arc.to) - graph_.vertex_weight[v]);
    if ((*side_)[arc.to] != other) continue;
    changes_.push_back({arc.to, other});
    put(arc.to, middle);
    for (const Arc& next : graph_.row(arc.to))
      if (queue_[to].contains(next.to))
        queue_[to].set(next.to, queue_[to].gain(next.to) + graph_.vertex_weight[arc.to]);
    file(arc.to);
  }
}

/// returns whether the separator became better
bool SeparatorFm::pass() {
  std::ranges::fill(moved_, 0);
  changes_.clear();
  for (GainQueue& queue : queue_) queue.clear();
  std::size_t size = 0;
  for (std::uint32_t v = 0; v < graph_.size(); ++v)
    if ((*side_)[v] == middle) {
      file(v);
      ++size;
    }
  const std::size_t patience = std::clamp<std::size_t>(2 * size, 30, 300);
  const SeparatorQuality before = quality_of(weight_, limit_);
  SeparatorQuality best = before;
  std::size_t best_length = 0;
  for (std::size_t fruitless = 0; fruitless < patience; ++fruitless) {
    const int to = next_side();
    if (to < 0) break;
    move(static_cast<std::uint32_t>(to));
    if (const SeparatorQuality now = quality_of(weight_, limit_); now < best) {
      best = now;
      best_length = changes_.size();
      fruitless = 0;
    }
  }
  for (; changes_.size() > best_length; changes_.pop_back())
    put(changes_.back().vertex, changes_.back().from);
  return best < before;
}

}  // namespace leonhard::graph::detail
