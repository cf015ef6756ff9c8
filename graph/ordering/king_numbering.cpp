// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering/king_numbering.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>

#include "leonhard/graph/ordering/level_search.hpp"

namespace leonhard::graph::detail {
namespace {

/// A heap with outdated entries: a vertex's count of inactive neighbours only falls, so that its last entry comes first,
/// and those that come when it is numbered are passed over.
class KingNumbering {
 public:
  KingNumbering(const CsrGraph& graph, std::span<const std::uint32_t> level_of)
      : graph_(graph),
        level_of_(level_of),
        inactive_neighbours_(vertex_count(graph)),
        arrival_(vertex_count(graph), not_arrived),
        numbered_(vertex_count(graph), 0),
        waiting_(level_of.empty() ? 1 : std::ranges::max(level_of) + std::size_t{1}) {
    for (const std::uint32_t v : vertices_by_degree(graph)) {
      inactive_neighbours_[v] = degree(graph, v);
      waiting_[level(v)].members.push_back(v);
    }
    for (Level& level : waiting_) level.left = level.members.size();
    order_.reserve(vertex_count(graph));
  }

  std::vector<std::uint32_t> from(std::uint32_t root, StepCounter& steps) {
    activate(root);
    for (std::size_t current = 0; order_.size() < vertex_count(graph_) && steps.step();) {
      while (waiting_[current].left == 0) ++current;
      number(next(current));
    }
    return std::move(order_);
  }

 private:
  static constexpr std::uint32_t not_arrived = std::numeric_limits<std::uint32_t>::max();
  using Entry =
      std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // inactive neighbours, arrival, vertex

  struct Level {
    std::vector<std::uint32_t> members;  ///< by degree
    std::size_t first_inactive = 0;      ///< no member before has yet to come to the front
    std::size_t left{};                  ///< not yet numbered
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  };

  [[nodiscard]] std::size_t level(std::uint32_t v) const { return level_of_.empty() ? 0 : level_of_[v]; }
  [[nodiscard]] bool is_in_front(std::uint32_t v) const {
    return arrival_[v] != not_arrived && numbered_[v] == 0;
  }
  void file(std::uint32_t v) { waiting_[level(v)].front.push({inactive_neighbours_[v], arrival_[v], v}); }

  /// v comes to the front, and its neighbours there would bring one vertex less.
  void activate(std::uint32_t v) {
    arrival_[v] = arrivals_++;
    file(v);
    for (const std::uint32_t w : neighbours(graph_, v)) {
      --inactive_neighbours_[w];
      if (is_in_front(w)) file(w);
    }
  }
  void number(std::uint32_t v) {
    numbered_[v] = 1;
    order_.push_back(v);
    --waiting_[level(v)].left;
    for (const std::uint32_t w : neighbours(graph_, v))
      if (arrival_[w] == not_arrived) activate(w);
  }
  /// The best vertex of the level's front; where none of its vertices is there, the one of least degree.
  std::uint32_t next(std::size_t current) {
    Level& level = waiting_[current];
    while (!level.front.empty()) {
      const std::uint32_t v = std::get<2>(level.front.top());
      level.front.pop();
      if (numbered_[v] == 0) return v;
    }
    while (arrival_[level.members[level.first_inactive]] != not_arrived) ++level.first_inactive;
    const std::uint32_t v = level.members[level.first_inactive];
    activate(v);
    return v;
  }

  const CsrGraph& graph_;
  std::span<const std::uint32_t> level_of_;
  std::vector<std::uint32_t> inactive_neighbours_;  ///< neither numbered nor in the front
  std::vector<std::uint32_t> arrival_;              ///< at the front
  std::vector<char> numbered_;
  std::vector<Level> waiting_;
  std::vector<std::uint32_t> order_;
  std::uint32_t arrivals_ = 0;
};

}  // namespace

std::vector<std::uint32_t> king_numbering(const CsrGraph& graph, std::uint32_t root,
                                          std::span<const std::uint32_t> level_of, StepCounter& steps) {
  return KingNumbering(graph, level_of).from(root, steps);
}

}  // namespace leonhard::graph::detail
