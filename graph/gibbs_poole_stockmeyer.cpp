// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "leonhard/graph/by_component.hpp"
#include "leonhard/graph/level_search.hpp"
#include "leonhard/graph/ordering.hpp"

namespace leonhard::graph {
namespace {

using Levels = std::vector<std::uint32_t>;  ///< to each vertex its level

/// Two level structures, from one end and, counted backwards, from the other; and the vertices about which they
/// differ, in connected groups, the largest first.
class LevelPair {
 public:
  LevelPair(const CsrGraph& graph, const detail::PseudoDiameter& ends, detail::LevelSearch& search)
      : graph_(graph), depth_(ends.depth), levels_{Levels(vertex_count(graph)), Levels(vertex_count(graph))} {
    search(ends.from);
    search.write_levels(levels_[0]);
    width_[0] = search.width();
    search(ends.to);
    search.write_levels(levels_[1]);
    width_[1] = search.width();
    for (std::uint32_t& level : levels_[1]) level = depth_ - level;
  }

  /// One structure no wider than needed: groups go as a whole to the structure in which they widen the widest of
  /// their levels less (algorithm II).
  [[nodiscard]] Levels merged() {
    std::vector<std::uint32_t> size(depth_ + std::size_t{1}, 0);
    for (std::uint32_t v = 0; v < levels_[0].size(); ++v)
      if (levels_[0][v] == levels_[1][v]) ++size[levels_[0][v]];
    Levels result = levels_[0];
    for (const std::vector<std::uint32_t>& group : groups_that_differ()) {
      const std::uint32_t widest_0 = widest_with(group, 0, size), widest_1 = widest_with(group, 1, size);
      const bool second = widest_0 != widest_1 ? widest_1 < widest_0 : width_[1] < width_[0];
      for (const std::uint32_t v : group) {
        result[v] = levels_[second ? 1 : 0][v];
        ++size[result[v]];
      }
    }
    return result;
  }

 private:
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> groups_that_differ() const {
    const auto differs = [&](std::uint32_t v) { return levels_[0][v] != levels_[1][v]; };
    std::vector<char> seen(levels_[0].size(), 0);
    std::vector<std::vector<std::uint32_t>> groups;
    for (std::uint32_t root = 0; root < levels_[0].size(); ++root) {
      if (seen[root] != 0 || !differs(root)) continue;
      std::vector<std::uint32_t> group{root};
      seen[root] = 1;
      for (std::size_t i = 0; i < group.size(); ++i)
        for (const std::uint32_t w : neighbours(graph_, group[i]))
          if (seen[w] == 0 && differs(w)) {
            seen[w] = 1;
            group.push_back(w);
          }
      groups.push_back(std::move(group));
    }
    std::ranges::stable_sort(groups, std::ranges::greater{}, &std::vector<std::uint32_t>::size);
    return groups;
  }

  /// The largest size of the levels that the group would enlarge. Leaves `size` as it was.
  [[nodiscard]] std::uint32_t widest_with(const std::vector<std::uint32_t>& group, std::size_t which,
                                          std::vector<std::uint32_t>& size) const {
    std::uint32_t widest = 0;
    for (const std::uint32_t v : group) widest = std::max(widest, ++size[levels_[which][v]]);
    for (const std::uint32_t v : group) --size[levels_[which][v]];
    return widest;
  }

  const CsrGraph& graph_;
  std::uint32_t depth_;
  std::array<Levels, 2> levels_;
  std::array<std::uint32_t, 2> width_{};
};

/// Numbers level after level (algorithm III): first the neighbours of what is numbered in the level before, in its
/// sequence, then the neighbours of what is numbered in the level itself, each by increasing degree.
class LevelNumbering {
 public:
  LevelNumbering(const CsrGraph& graph, const Levels& level_of, std::uint32_t depth)
      : graph_(graph), level_of_(level_of), members_(depth + std::size_t{1}), numbered_(level_of.size(), 0) {
    for (const std::uint32_t v : detail::vertices_by_degree(graph)) members_[level_of[v]].push_back(v);
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
  const Levels& level_of_;
  std::vector<std::vector<std::uint32_t>> members_;  ///< of each level, by degree
  std::vector<char> numbered_;
  std::vector<std::uint32_t> order_;
};

std::vector<std::uint32_t> order_connected(const CsrGraph& graph) {
  detail::LevelSearch search(graph);
  detail::PseudoDiameter ends =
      detail::pseudo_diameter(graph, search, detail::vertices_by_degree(graph).front());
  Levels level_of = LevelPair(graph, ends, search).merged();
  if (degree(graph, ends.to) < degree(graph, ends.from)) {
    std::swap(ends.from, ends.to);
    for (std::uint32_t& level : level_of) level = ends.depth - level;
  }
  return detail::better_direction(graph, LevelNumbering(graph, level_of, ends.depth).from(ends.from));
}

}  // namespace

std::vector<std::uint32_t> gibbs_poole_stockmeyer(const CsrGraph& graph) {
  return detail::order_by_component(
      graph, [](const CsrGraph& connected, const auto&) { return order_connected(connected); });
}

}  // namespace leonhard::graph
