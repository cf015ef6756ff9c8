// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering/combined_levels.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "leonhard/graph/ordering/level_search.hpp"

namespace leonhard::graph::detail {
namespace {

using Levels = std::vector<std::uint32_t>;  ///< to each vertex its level

/// Two level structures, from one end and, counted backwards, from the other; and the vertices about which they
/// differ, in connected groups, the largest first.
class LevelPair {
 public:
  LevelPair(const CsrGraph& graph, const PseudoDiameter& ends, LevelSearch& search)
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

}  // namespace

CombinedLevels combined_levels(const CsrGraph& graph, StepCounter& steps) {
  LevelSearch search(graph);
  const PseudoDiameter ends = pseudo_diameter(graph, search, vertices_by_degree(graph).front(), steps);
  if (!steps.goes_on()) return {};
  CombinedLevels result{ends.from, ends.depth, LevelPair(graph, ends, search).merged()};
  if (degree(graph, ends.to) < degree(graph, ends.from)) {
    result.root = ends.to;
    for (std::uint32_t& level : result.level_of) level = ends.depth - level;
  }
  return result;
}

}  // namespace leonhard::graph::detail
