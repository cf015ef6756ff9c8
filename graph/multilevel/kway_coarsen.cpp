// SPDX-License-Identifier: MIT
#include "leonhard/graph/multilevel/kway_coarsen.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace leonhard::graph::detail {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

class Matching {
 public:
  Matching(const KwayGraph& graph, std::int64_t largest, std::span<const std::uint32_t> label, Random& random)
      : graph_(graph), largest_(largest), label_(label), random_(random), mate_(graph.size(), none) {}

  Clusters operator()() {
    const std::vector<std::uint32_t> order = random_.permutation(graph_.size());
    std::uint32_t alone = 0;
    for (const std::uint32_t v : order)
      if (mate_[v] == none) {
        const std::uint32_t mate = best_neighbour(v);
        if (mate == none)
          ++alone;
        else
          join(v, mate);
      }
    if (alone > graph_.size() / 10) pair_around_hubs(order);
    return numbered();
  }

 private:
  [[nodiscard]] bool fit(std::uint32_t v, std::uint32_t w) const {
    return std::int64_t{graph_.vertex_weight[v]} + graph_.vertex_weight[w] <= largest_ &&
           (label_.empty() || label_[v] == label_[w]);
  }

  std::uint32_t best_neighbour(std::uint32_t v) {
    double best = 0;
    std::uint32_t chosen = none, equals = 0;
    for (const Arc& arc : graph_.row(v)) {
      if (mate_[arc.to] != none || !fit(v, arc.to)) continue;
      const double rating = double{1} * arc.weight * arc.weight / graph_.vertex_weight[arc.to];
      if (rating < best) continue;
      equals = rating > best ? 1 : equals + 1;
      if (equals > 1 && random_.below(equals) > 0) continue;
      best = rating;
      chosen = arc.to;
    }
    return chosen;
  }

  void join(std::uint32_t v, std::uint32_t w) {
    mate_[v] = w;
    mate_[w] = v;
  }

  void pair_around_hubs(std::span<const std::uint32_t> order) {
    std::vector<std::uint32_t> waiting(graph_.size(), none);  // per hub: a vertex that looks for another
    for (const std::uint32_t v : order) {
      if (mate_[v] != none || graph_.row(v).empty()) continue;
      const std::uint32_t hub = std::ranges::max_element(graph_.row(v), {}, &Arc::weight)->to;
      const std::uint32_t other = std::exchange(waiting[hub], none);
      if (other != none && fit(v, other))
        join(v, other);
      else
        waiting[hub] = v;
    }
  }

  Clusters numbered() const {
    Clusters result{std::vector<std::uint32_t>(graph_.size()), 0};
    for (std::uint32_t v = 0; v < graph_.size(); ++v)
      result.cluster_of[v] = mate_[v] < v ? result.cluster_of[mate_[v]] : result.count++;
    return result;
  }

  const KwayGraph& graph_;
  std::int64_t largest_;
  std::span<const std::uint32_t> label_;
  Random& random_;
  std::vector<std::uint32_t> mate_;  ///< per vertex: whom it is joined with, or none
};

}  // namespace

Clusters heavy_edge_matching(const KwayGraph& graph, std::int64_t largest,
                             std::span<const std::uint32_t> label, Random& random) {
  return Matching(graph, largest, label, random)();
}

KwayGraph contract(const KwayGraph& graph, const Clusters& clusters) {
  const auto members = collect_rows<std::uint32_t>(clusters.count, [&](const auto& add) {
    for (std::uint32_t v = 0; v < graph.size(); ++v) add(clusters.cluster_of[v], v);
  });

  KwayGraph coarse;
  coarse.arcs.reserve(clusters.count, graph.arcs.link_count());
  coarse.vertex_weight.assign(clusters.count, 0);
  coarse.total_weight = graph.total_weight;
  std::vector<std::uint32_t> slot(clusters.count, none);  // per cluster: its arc in the last row that had one
  for (std::uint32_t c = 0; c < clusters.count; ++c) {
    const auto row = static_cast<std::uint32_t>(coarse.arcs.link_count());
    for (const std::uint32_t member : members[c]) {
      coarse.vertex_weight[c] += graph.vertex_weight[member];
      for (const Arc& arc : graph.row(member)) {
        const std::uint32_t d = clusters.cluster_of[arc.to];
        if (d == c) continue;
        if (slot[d] != none && slot[d] >= row) {
          coarse.arcs.links()[slot[d]].weight += arc.weight;
        } else {
          slot[d] = static_cast<std::uint32_t>(coarse.arcs.link_count());
          coarse.arcs.add_link({d, arc.weight});
        }
      }
    }
    coarse.arcs.end_row();
  }
  return coarse;
}

std::int64_t allowance(const KwayGraph& coarse) {
  return coarse.size() == 0 ? 0 : std::ranges::max(coarse.vertex_weight);
}

Hierarchy::Hierarchy(const KwayGraph& graph, std::uint32_t size, std::vector<std::uint32_t> label,
                     Random& random, const std::stop_token& stop)
    : finest_(&graph) {
  const std::int64_t largest = std::max<std::int64_t>(1, 3 * graph.total_weight / size);
  while (coarsest().size() > size && !stop.stop_requested()) {
    const KwayGraph& fine = coarsest();
    Clusters clusters = heavy_edge_matching(fine, largest, label, random);
    if (clusters.count > 0.95 * fine.size()) break;
    if (!label.empty()) {
      for (std::uint32_t v = 0; v < fine.size(); ++v)
        label[clusters.cluster_of[v]] = label[v];  // cluster_of[v] <= v
      label.resize(clusters.count);
    }
    KwayGraph coarse = contract(fine, clusters);
    coarse_.push_back({std::move(coarse), std::move(clusters.cluster_of)});
  }
}

std::vector<std::uint32_t> Hierarchy::project(std::size_t depth,
                                              std::span<const std::uint32_t> values) const {
  std::vector<std::uint32_t> result;
  result.reserve(level(depth).size());
  for (const std::uint32_t c : coarse_[depth].cluster_of) result.push_back(values[c]);
  return result;
}

std::vector<std::uint32_t> Hierarchy::to_coarsest(std::vector<std::uint32_t> values) const {
  for (const Level& level : coarse_) {
    std::vector<std::uint32_t> coarse(level.graph.size());
    for (std::size_t v = 0; v < values.size(); ++v) coarse[level.cluster_of[v]] = values[v];
    values = std::move(coarse);
  }
  return values;
}

}  // namespace leonhard::graph::detail
