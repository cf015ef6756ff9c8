// SPDX-License-Identifier: MIT
#include "leonhard/graph/partition/kway_initial.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace leonhard::graph::detail {
namespace {

BisectionGoal goal_of(std::int64_t weight, std::uint32_t parts, std::int64_t limit) {
  const std::uint32_t lower = parts / 2;
  const int depth = std::bit_width(parts - 1);  // levels of bisections still to come, this one included
  const double room = static_cast<double>(parts) * static_cast<double>(limit) / static_cast<double>(weight);
  const double slack = std::pow(std::max(room, 1.0), 1.0 / depth);
  BisectionGoal goal{};
  goal.target[0] = weight * lower / parts;
  goal.target[1] = weight - goal.target[0];
  for (const int s : {0, 1}) {
    const std::int64_t at_most = limit * (s == 0 ? lower : parts - lower);
    const auto shared = static_cast<std::int64_t>(slack * static_cast<double>(goal.target[s]));
    goal.limit[s] = std::max(goal.target[s], std::min(at_most, shared));
  }
  return goal;
}

class Recursion {
 public:
  Recursion(const KwayGraph& whole, std::int64_t limit, const BisectionSettings& settings, Random& random,
            const std::stop_token& stop)
      : subgraph_(whole),
        limit_(limit),
        settings_(settings),
        random_(random),
        stop_(stop),
        part_of_(whole.size(), 0) {}

  std::vector<std::uint32_t> operator()(const KwayGraph& whole, std::uint32_t parts) {
    std::vector<std::uint32_t> all(whole.size());
    std::iota(all.begin(), all.end(), 0U);
    split(whole, all, 0, parts);
    return std::move(part_of_);
  }

 private:
  /// The vertices, all of part `first` so far, are shared between parts [first, first + parts).
  void split(const KwayGraph& graph, const std::vector<std::uint32_t>& vertices, std::uint32_t first,
             std::uint32_t parts) {
    if (parts == 1 || vertices.empty()) return;
    const std::vector<std::uint32_t> side =
        multilevel_bisection(graph, goal_of(graph.total_weight, parts, limit_), settings_, random_, stop_);
    std::vector<std::uint32_t> lower, upper;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      (side[i] == 0 ? lower : upper).push_back(vertices[i]);
      part_of_[vertices[i]] = first + (side[i] == 0 ? 0 : parts / 2);
    }
    descend(lower, first, parts / 2);
    descend(upper, first + parts / 2, parts - parts / 2);
  }
  void descend(const std::vector<std::uint32_t>& vertices, std::uint32_t first, std::uint32_t parts) {
    if (parts > 1) split(subgraph_(vertices, part_of_), vertices, first, parts);
  }

  KwaySubgraph subgraph_;
  std::int64_t limit_;
  const BisectionSettings& settings_;
  Random& random_;
  const std::stop_token& stop_;
  std::vector<std::uint32_t> part_of_;
};

}  // namespace

std::vector<std::uint32_t> recursive_multilevel_bisection(const KwayGraph& graph, std::uint32_t parts,
                                                          std::int64_t limit,
                                                          const BisectionSettings& settings, Random& random,
                                                          const std::stop_token& stop) {
  return Recursion(graph, limit, settings, random, stop)(graph, parts);
}

}  // namespace leonhard::graph::detail
