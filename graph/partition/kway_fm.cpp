// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/kway_fm.hpp"

#include <algorithm>

namespace leonhard::graph::detail {

KwayFm::KwayFm(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit,
               std::vector<std::uint32_t>& part_of, Random& random)
    : graph_(graph),
      limit_(limit),
      part_of_(part_of),
      random_(random),
      weight_(part_weights(graph, part_of, parts)),
      connection_(parts, 0),
      moved_(graph.size(), 0),
      queue_(graph.size()) {}

KwayFm::Move KwayFm::best_move(std::uint32_t v) {
  const std::uint32_t own = part_of_[v];
  beside_.clear();
  std::int32_t inside = 0;
  for (const Arc& arc : graph_.row(v)) {
    const std::uint32_t part = part_of_[arc.to];
    if (part == own) {
      inside += arc.weight;
      continue;
    }
    if (connection_[part] == 0) beside_.push_back(part);
    connection_[part] += arc.weight;
  }
  Move best{0, none};
  std::int32_t most = 0;
  for (const std::uint32_t part : beside_) {
    const std::int32_t connected = connection_[part];
    connection_[part] = 0;
    if (weight_[part] + graph_.vertex_weight[v] > limit_ || connected < most) continue;
    if (connected == most && weight_[part] >= weight_[best.to]) continue;
    most = connected;
    best = {connected - inside, part};
  }
  return best;
}

bool KwayFm::on_boundary(std::uint32_t v) const {
  return std::ranges::any_of(graph_.row(v), [&](const Arc& arc) { return part_of_[arc.to] != part_of_[v]; });
}

void KwayFm::move(std::uint32_t v, std::uint32_t to) {
  weight_[part_of_[v]] -= graph_.vertex_weight[v];
  weight_[to] += graph_.vertex_weight[v];
  part_of_[v] = to;
}

std::uint32_t KwayFm::lightest_part() const {
  return static_cast<std::uint32_t>(std::ranges::min_element(weight_) - weight_.begin());
}

bool KwayFm::rebalance() {
  const auto too_heavy = [&](std::uint32_t part) { return weight_[part] > limit_; };
  if (std::ranges::all_of(weight_, [&](std::int64_t w) { return w <= limit_; })) return true;
  queue_.clear();
  const auto gain_of = [&](std::uint32_t v) {
    const Move best = best_move(v);
    if (best.to != none) return best.gain;
    std::int32_t inside = 0;  // it has to jump: all its edges inside its part are cut
    for (const Arc& arc : graph_.row(v)) inside += part_of_[arc.to] == part_of_[v] ? arc.weight : 0;
    return -inside;
  };
  for (std::uint32_t v = 0; v < graph_.size(); ++v)
    if (too_heavy(part_of_[v])) queue_.set(v, gain_of(v));
  while (!queue_.empty()) {
    const std::int32_t expected = queue_.top_gain();
    const std::uint32_t v = queue_.pop();
    if (!too_heavy(part_of_[v])) continue;
    const std::int32_t gain = gain_of(v);  // parts may have filled up since
    if (gain < expected && !queue_.empty() && gain < queue_.top_gain()) {
      queue_.set(v, gain);
      continue;
    }
    std::uint32_t to = best_move(v).to;
    if (to == none) to = lightest_part();
    if (weight_[to] + graph_.vertex_weight[v] > limit_) continue;
    move(v, to);
    for (const Arc& arc : graph_.row(v))
      if (queue_.contains(arc.to)) queue_.set(arc.to, gain_of(arc.to));
  }
  return std::ranges::all_of(weight_, [&](std::int64_t w) { return w <= limit_; });
}

std::int32_t KwayFm::search(std::uint32_t seed, std::uint32_t patience) {
  queue_.clear();
  steps_.clear();
  const auto consider = [&](std::uint32_t v) {
    const Move best = best_move(v);
    if (best.to != none)
      queue_.set(v, best.gain);
    else if (queue_.contains(v))
      queue_.remove(v);
  };
  consider(seed);
  std::int32_t gained = 0, best = 0;
  std::size_t best_length = 0;
  while (!queue_.empty() && steps_.size() < best_length + patience) {
    const std::int32_t expected = queue_.top_gain();
    const std::uint32_t v = queue_.pop();
    const Move next = best_move(v);
    if (next.to == none) continue;
    if (next.gain < expected && !queue_.empty() && next.gain < queue_.top_gain()) {
      queue_.set(v, next.gain);
      continue;
    }
    moved_[v] = 1;
    steps_.push_back({v, part_of_[v]});
    move(v, next.to);
    gained += next.gain;
    if (gained > best) {
      best = gained;
      best_length = steps_.size();
    }
    for (const Arc& arc : graph_.row(v))
      if (!moved_[arc.to]) consider(arc.to);
  }
  while (steps_.size() > best_length) {
    move(steps_.back().vertex, steps_.back().from);
    moved_[steps_.back().vertex] = 0;
    steps_.pop_back();
  }
  return best;
}

/// The whole boundary, or what of it is near to the last round's moves; in random sequence.
std::vector<std::uint32_t> KwayFm::seeds() {
  std::vector<std::uint32_t> result;
  std::ranges::fill(moved_, 0);
  const auto add = [&](std::uint32_t v) {
    if (moved_[v] || !on_boundary(v)) return;
    moved_[v] = 1;
    result.push_back(v);
  };
  if (first_round_) {
    for (std::uint32_t v = 0; v < graph_.size(); ++v) add(v);
  } else {
    for (const std::uint32_t v : settled_) {
      add(v);
      for (const Arc& arc : graph_.row(v)) add(arc.to);
    }
  }
  for (const std::uint32_t v : result) moved_[v] = 0;
  first_round_ = false;
  random_.shuffle(result);
  return result;
}

std::int64_t KwayFm::search_round(std::uint32_t patience, const std::stop_token& stop) {
  const std::vector<std::uint32_t> start = seeds();
  settled_.clear();
  std::int64_t gained = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (i % 256 == 0 && stop.stop_requested()) break;
    if (moved_[start[i]]) continue;
    gained += search(start[i], patience);
    for (const Step& step : steps_) settled_.push_back(step.vertex);
  }
  return gained;
}

}  // namespace leonhard::graph::detail
