// SPDX-License-Identifier: MIT
#include "leonhard/graph/separator/separator_flow.hpp"

#include <algorithm>
#include <array>

namespace leonhard::graph::detail {
namespace {

/// A vertex of the strip is two of the network, joined by an arc of its weight.
constexpr std::uint32_t in(std::uint32_t i) { return 2 * i; }
constexpr std::uint32_t out(std::uint32_t i) { return 2 * i + 1; }

constexpr std::int32_t no_limit = std::numeric_limits<std::int32_t>::max();

}  // namespace

SeparatorFlow::SeparatorFlow(const KwayGraph& graph, std::int64_t limit)
    : graph_(graph), limit_(limit), local_(graph.size(), none) {}

/// The separator, then breadth first what is next to it on either side.
void SeparatorFlow::grow_strip(const Sides& side, const SideWeights& weight, std::int64_t depth) {
  strip_.clear();
  const auto take = [&](std::uint32_t v) {
    local_[v] = static_cast<std::uint32_t>(strip_.size());
    strip_.push_back(v);
  };
  for (std::uint32_t v = 0; v < graph_.size(); ++v)
    if (side[v] == middle) take(v);
  std::array<std::int64_t, 2> budget{};
  for (const std::uint32_t s : {0U, 1U})
    budget[s] = std::min({limit_ - weight[1 - s] - weight[middle], depth * weight[middle], weight[s] - 1});
  for (std::size_t i = 0; i < strip_.size(); ++i)
    for (const Arc& arc : graph_.row(strip_[i])) {
      if (local_[arc.to] != none || graph_.vertex_weight[arc.to] > budget[side[arc.to]]) continue;
      budget[side[arc.to]] -= graph_.vertex_weight[arc.to];
      take(arc.to);
    }
}

/// returns whether there is something on both sides of the strip
bool SeparatorFlow::build_network(const Sides& side) {
  bool source = false, sink = false;
  flow_.clear();
  for (std::uint32_t i = 0; i < strip_.size(); ++i) {
    const std::uint32_t v = strip_[i];
    std::array<bool, 2> beside{};
    for (const Arc& arc : graph_.row(v))
      if (local_[arc.to] == none) beside[side[arc.to]] = true;
    flow_.add_vertex();  // in
    if (beside[0]) flow_.add_source_edge(no_limit);
    for (const Arc& arc : graph_.row(v))
      if (const std::uint32_t j = local_[arc.to]; j < i) flow_.add_edge(out(j), 0, no_limit);
    flow_.add_vertex();  // out
    if (beside[1]) flow_.add_sink_edge(no_limit);
    flow_.add_edge(in(i), 0, graph_.vertex_weight[v]);
    for (const Arc& arc : graph_.row(v))
      if (const std::uint32_t j = local_[arc.to]; j < i) flow_.add_edge(in(j), no_limit, 0);
    source |= beside[0];
    sink |= beside[1];
  }
  return source && sink;
}

SideWeights SeparatorFlow::weights_by(const Sides& side, const std::vector<std::uint32_t>& of_strip,
                                      SideWeights weight) const {
  for (std::uint32_t i = 0; i < strip_.size(); ++i) {
    weight[side[strip_[i]]] -= graph_.vertex_weight[strip_[i]];
    weight[of_strip[i]] += graph_.vertex_weight[strip_[i]];
  }
  return weight;
}

bool SeparatorFlow::improve(Sides& side, std::int64_t depth) {
  const SideWeights weight = weights_of(graph_, side);
  grow_strip(side, weight, depth);
  bool better = false;
  if (weight[middle] > 0 && build_network(side)) {
    static_cast<void>(flow_.maximum(weight[middle] + 1));  // the separator is a cut: no flow is larger
    // Two minimum cuts: the nearest to side 0, the nearest to side 1.
    const std::vector<char> to_sink = flow_.reaching_sink();
    std::vector<std::uint32_t> near_0(strip_.size()), near_1(strip_.size());
    for (std::uint32_t i = 0; i < strip_.size(); ++i) {
      near_0[i] = flow_.reached_from_source(out(i)) ? 0 : flow_.reached_from_source(in(i)) ? middle : 1;
      near_1[i] = to_sink[in(i)] ? 1 : to_sink[out(i)] ? middle : 0;
    }
    SeparatorQuality best = quality_of(weight, limit_);
    const std::vector<std::uint32_t>* chosen = nullptr;
    for (const auto* candidate : {&near_0, &near_1})
      if (const auto quality = quality_of(weights_by(side, *candidate, weight), limit_); quality < best) {
        best = quality;
        chosen = candidate;
      }
    better = chosen != nullptr;
    if (better)
      for (std::uint32_t i = 0; i < strip_.size(); ++i) side[strip_[i]] = (*chosen)[i];
  }
  for (const std::uint32_t v : strip_) local_[v] = none;
  return better;
}

}  // namespace leonhard::graph::detail
