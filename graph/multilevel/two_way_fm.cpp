// SPDX-License-Identifier: MIT
#include "leonhard/graph/multilevel/two_way_fm.hpp"

#include <algorithm>

namespace leonhard::graph::detail {

TwoWayFm::TwoWayFm(const KwayGraph& graph, const BisectionGoal& goal)
    : graph_(graph),
      goal_(goal),
      passing_excess_(graph.size() == 0 ? 0 : std::ranges::max(graph.vertex_weight)),
      queue_{GainQueue(graph.size()), GainQueue(graph.size())},
      moved_in_(graph.size(), 0) {}

TwoWayFm::Gain TwoWayFm::gain(const std::vector<std::uint32_t>& side, std::uint32_t v) const {
  Gain result{0, false};
  for (const Arc& arc : graph_.row(v)) {
    const bool across = side[arc.to] != side[v];
    result.value += across ? arc.weight : -arc.weight;
    result.on_boundary |= across;
  }
  return result;
}

void TwoWayFm::fill_queues(const std::vector<std::uint32_t>& side) {
  queue_[0].clear();
  queue_[1].clear();
  for (std::uint32_t v = 0; v < graph_.size(); ++v) {
    const Gain g = gain(side, v);
    // A side over its limit may have to give vertices from anywhere.
    if (g.on_boundary || excess_if(weight_[side[v]], side[v]) > 0) queue_[side[v]].set(v, g.value);
  }
}

/// From which side to move: the one over its limit, else the one with the better vertex, else the heavier.
std::uint32_t TwoWayFm::next_source() const {
  for (const std::uint32_t s : {0U, 1U})
    if (excess_if(weight_[s], s) > 0) return s;
  for (const std::uint32_t s : {0U, 1U})
    if (queue_[s].empty()) return 1 - s;
  if (queue_[0].top_gain() != queue_[1].top_gain())
    return queue_[0].top_gain() > queue_[1].top_gain() ? 0 : 1;
  return weight_[0] - goal_.target[0] >= weight_[1] - goal_.target[1] ? 0 : 1;
}

void TwoWayFm::move(std::vector<std::uint32_t>& side, std::uint32_t v) {
  weight_[side[v]] -= graph_.vertex_weight[v];
  side[v] = 1 - side[v];
  weight_[side[v]] += graph_.vertex_weight[v];
}

/// returns whether the cut, or else the excess, became less
bool TwoWayFm::pass(std::vector<std::uint32_t>& side) {
  ++pass_;
  moves_.clear();
  fill_queues(side);
  const std::size_t patience = 25 + graph_.size() / 50;
  const std::pair start{excess(), cut_};
  std::pair best = start;
  std::int64_t best_tilt = std::abs(weight_[0] - goal_.target[0]);
  std::size_t best_length = 0;
  while (moves_.size() < best_length + patience) {
    const std::uint32_t from = next_source();
    if (queue_[from].empty()) break;
    const std::int32_t gained = queue_[from].top_gain();
    const std::uint32_t v = queue_[from].pop();
    moved_in_[v] = pass_;
    const std::uint32_t to = 1 - from;
    const std::int64_t weight = graph_.vertex_weight[v];
    if (excess_if(weight_[to] + weight, to) > std::max(excess_if(weight_[from], from), passing_excess_))
      continue;
    move(side, v);
    moves_.push_back(v);
    cut_ -= gained;
    for (const Arc& arc : graph_.row(v)) {
      if (moved_in_[arc.to] == pass_) continue;
      GainQueue& queue = queue_[side[arc.to]];
      if (queue.contains(arc.to))
        queue.set(arc.to, queue.gain(arc.to) + (side[arc.to] == from ? 2 : -2) * arc.weight);
      else
        queue.set(arc.to, gain(side, arc.to).value);
    }
    const std::pair now{excess(), cut_};
    const std::int64_t tilt = std::abs(weight_[0] - goal_.target[0]);
    if (now < best || (now == best && tilt < best_tilt)) {
      best = now;
      best_tilt = tilt;
      best_length = moves_.size();
    }
  }
  while (moves_.size() > best_length) {
    move(side, moves_.back());
    moves_.pop_back();
  }
  cut_ = best.second;
  return best < start;
}

std::int64_t TwoWayFm::refine(std::vector<std::uint32_t>& side, std::uint32_t passes) {
  weight_ = {};
  for (std::uint32_t v = 0; v < graph_.size(); ++v) weight_[side[v]] += graph_.vertex_weight[v];
  cut_ = cut_of(graph_, side);
  for (std::uint32_t i = 0; i < passes; ++i)
    if (!pass(side)) break;
  return cut_;
}

}  // namespace leonhard::graph::detail
