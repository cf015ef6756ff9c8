// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/kway_flow.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace leonhard::graph::detail {

KwayFlow::KwayFlow(const KwayGraph& graph, std::vector<Room> room, std::vector<std::uint32_t>& part_of,
                   Random& random)
    : graph_(graph),
      parts_(static_cast<std::uint32_t>(room.size())),
      room_(std::move(room)),
      part_of_(part_of),
      random_(random),
      weight_(part_weights(graph, part_of, parts_)),
      active_(parts_, 1),
      local_(graph.size(), none) {}

std::vector<KwayFlow::Pair> KwayFlow::touching_pairs() {
  std::vector<Pair> pairs;
  std::unordered_map<std::uint64_t, std::size_t> place;  // of a pair of parts
  std::vector<std::uint32_t> beside;
  for (std::uint32_t v = 0; v < graph_.size(); ++v) {
    const std::uint32_t own = part_of_[v];
    beside.clear();
    for (const Arc& arc : graph_.row(v)) {
      const std::uint32_t other = part_of_[arc.to];
      if (other == own || !(active_[own] || active_[other])) continue;
      if (std::ranges::count(beside, other) > 0) continue;
      beside.push_back(other);
      const auto [a, b] = std::minmax(own, other);
      const auto [at, fresh] = place.try_emplace(std::uint64_t{a} * parts_ + b, pairs.size());
      if (fresh) pairs.push_back({a, b, {}});
      pairs[at->second].boundary.push_back(v);
    }
  }
  for (std::size_t i = pairs.size(); i > 1; --i)
    std::swap(pairs[i - 1], pairs[random_.below(static_cast<std::uint32_t>(i))]);
  return pairs;
}

/// Adds to the strip what is nearest to the boundary in one part, as heavy as the budget at most.
void KwayFlow::grow_strip(std::span<const std::uint32_t> boundary, std::uint32_t part, std::int64_t budget) {
  const std::size_t begin = strip_.size();
  const auto take = [&](std::uint32_t v) {
    if (part_of_[v] != part || local_[v] != none || graph_.vertex_weight[v] > budget) return;
    budget -= graph_.vertex_weight[v];
    local_[v] = static_cast<std::uint32_t>(strip_.size());
    strip_.push_back(v);
  };
  for (const std::uint32_t v : boundary) take(v);
  for (std::size_t i = begin; i < strip_.size() && budget > 0; ++i)
    for (const Arc& arc : graph_.row(strip_[i])) take(arc.to);
}

/// The network of the strip, the rest of part a its source, of b its sink. returns the cut as it is
std::int64_t KwayFlow::build_network(std::uint32_t a, std::uint32_t b) {
  std::int64_t cut = 0;
  flow_.clear();
  for (std::uint32_t i = 0; i < strip_.size(); ++i) {
    const std::uint32_t v = strip_[i], own = part_of_[v];
    flow_.add_vertex();
    for (const Arc& arc : graph_.row(v)) {
      const std::uint32_t other = part_of_[arc.to];
      if (other != a && other != b) continue;
      const std::uint32_t j = local_[arc.to];
      if (j == none) {
        other == a ? flow_.add_source_edge(arc.weight) : flow_.add_sink_edge(arc.weight);
      } else if (j < i) {
        flow_.add_edge(j, arc.weight);
      } else {
        continue;
      }
      cut += own != other ? arc.weight : 0;
    }
  }
  return cut;
}

/// What may be in the strip on the other side of a part. With reach 1 the part could take all of it.
std::int64_t KwayFlow::budget(std::uint32_t receiver, double reach) const {
  const auto [target, limit] = room_[receiver];
  return limit - weight_[receiver] +
         static_cast<std::int64_t>((reach - 1) * static_cast<double>(limit - target));
}

/// What a boundary's vertices in one part weigh, or some vertices of mean weight if that is more.
std::int64_t KwayFlow::breadth(std::uint32_t part, std::span<const std::uint32_t> boundary) const {
  constexpr std::int64_t least = 50;
  std::int64_t weight = 0;
  for (const std::uint32_t v : boundary) weight += part_of_[v] == part ? graph_.vertex_weight[v] : 0;
  return std::max(weight, least * graph_.total_weight / graph_.size());
}

/// By how much the worse part of a pair is over its limit (negative: it has room).
std::int64_t KwayFlow::excess(const Pair& pair, std::int64_t weight_of_a) const {
  const std::int64_t weight_of_b = weight_[pair.a] + weight_[pair.b] - weight_of_a;
  return std::max(weight_of_a - room_[pair.a].limit, weight_of_b - room_[pair.b].limit);
}

/// returns whether the partition changed
bool KwayFlow::improve(const Pair& pair, const Strip& strip) {
  const auto [a, b, boundary] = pair;
  strip_.clear();
  grow_strip(boundary, a, std::min(budget(b, strip.reach), strip.depth * breadth(a, boundary)));
  grow_strip(boundary, b, std::min(budget(a, strip.reach), strip.depth * breadth(b, boundary)));
  const std::int64_t cut = build_network(a, b);
  const std::int64_t flow = cut == 0 ? cut : flow_.maximum(cut + 1);
  bool done = false;
  const std::int64_t before = excess(pair, weight_[a]);
  if (flow <= cut && cut > 0) {
    // Two minimum cuts: the least for a, the least for b. The one that is better balanced.
    const std::vector<char> to_b = flow_.reaching_sink();
    std::array<std::int64_t, 2> weight_of_a{weight_[a], weight_[a]};
    for (std::uint32_t i = 0; i < strip_.size(); ++i) {
      const std::uint32_t v = strip_[i];
      const bool now = part_of_[v] == a;
      weight_of_a[0] += (int{flow_.reached_from_source(i)} - int{now}) * graph_.vertex_weight[v];
      weight_of_a[1] += (int{!to_b[i]} - int{now}) * graph_.vertex_weight[v];
    }
    const int which = excess(pair, weight_of_a[0]) <= excess(pair, weight_of_a[1]) ? 0 : 1;
    const std::int64_t after = excess(pair, weight_of_a[which]);
    if (after <= std::max<std::int64_t>(0, before) && (flow < cut || after < before)) {
      done = true;
      gained_ += cut - flow;
      weight_[b] += weight_[a] - weight_of_a[which];
      weight_[a] = weight_of_a[which];
      for (std::uint32_t i = 0; i < strip_.size(); ++i)
        part_of_[strip_[i]] = (which == 0 ? flow_.reached_from_source(i) : !to_b[i]) ? a : b;
    }
  }
  for (const std::uint32_t v : strip_) local_[v] = none;
  if (!done && flow < cut && strip.reach > 1)
    return improve(pair, {strip.reach > 2 ? strip.reach / 2 : 1, strip.depth});
  return done;
}

std::int64_t KwayFlow::round(const Strip& strip, const std::stop_token& stop) {
  gained_ = 0;
  changed_.assign(parts_, 0);
  for (const Pair& pair : touching_pairs()) {
    if (stop.stop_requested()) break;
    if (improve(pair, strip)) changed_[pair.a] = changed_[pair.b] = 1;
  }
  active_ = changed_;
  return gained_;
}

}  // namespace leonhard::graph::detail
