// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering/level_search.hpp"

#include <algorithm>
#include <limits>

#include "leonhard/graph/support/row_prefetch.hpp"

namespace leonhard::graph::detail {

std::uint32_t LevelSearch::operator()(std::uint32_t root) {
  ++current_;
  start_.assign({0, 1});
  stamp_[root] = current_;
  std::uint32_t* const queue = queue_.data();
  std::uint32_t* const stamp = stamp_.data();
  queue[0] = root;
  std::uint32_t tail = 1;
  for (std::uint32_t i = 0;;) {
    for (const std::uint32_t end = start_.back(); i < end; ++i) {
      prefetch_rows(graph_, {queue, tail}, i, [&](std::uint32_t w) { __builtin_prefetch(&stamp[w], 1); });
      for (const std::uint32_t w : neighbours(graph_, queue[i]))
        if (stamp[w] != current_) {
          stamp[w] = current_;
          queue[tail++] = w;
        }
    }
    if (tail == start_.back()) return depth();
    start_.push_back(tail);
  }
}

std::uint32_t LevelSearch::width() const {
  std::uint32_t widest = 0;
  for (std::size_t l = 1; l < start_.size(); ++l) widest = std::max(widest, start_[l] - start_[l - 1]);
  return widest;
}

void LevelSearch::write_levels(std::span<std::uint32_t> level_of) const {
  for (std::uint32_t l = 0; l <= depth(); ++l)
    for (const std::uint32_t v : level(l)) level_of[v] = l;
}

std::uint32_t least_degree(const CsrGraph& graph, std::span<const std::uint32_t> vertices) {
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t da = degree(graph, a), db = degree(graph, b);
    return da != db ? da < db : a < b;
  };
  return *std::ranges::min_element(vertices, before);
}

std::vector<std::uint32_t> vertices_by_degree(const CsrGraph& graph) {
  const std::uint32_t n = vertex_count(graph);
  std::vector<std::uint32_t> start;
  for (std::uint32_t v = 0; v < n; ++v) {
    const std::uint32_t d = degree(graph, v);
    if (start.size() < d + std::size_t{2}) start.resize(d + std::size_t{2}, 0);
    ++start[d + std::size_t{1}];
  }
  for (std::size_t d = 1; d < start.size(); ++d) start[d] += start[d - 1];
  std::vector<std::uint32_t> sorted(n);
  for (std::uint32_t v = 0; v < n; ++v) sorted[start[degree(graph, v)]++] = v;
  return sorted;
}

std::uint32_t pseudo_peripheral(const CsrGraph& graph, LevelSearch& search, std::uint32_t start) {
  std::uint32_t depth = search(start);
  while (true) {
    const std::uint32_t candidate = least_degree(graph, search.last_level());
    const std::uint32_t deeper = search(candidate);
    if (deeper <= depth) return candidate;
    depth = deeper;
  }
}

namespace {

/// One vertex of each degree, the smallest, by degree.
std::vector<std::uint32_t> one_of_each_degree(const CsrGraph& graph,
                                              std::span<const std::uint32_t> vertices) {
  std::vector<std::uint32_t> sorted(vertices.begin(), vertices.end());
  std::ranges::sort(sorted, [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t da = degree(graph, a), db = degree(graph, b);
    return da != db ? da < db : a < b;
  });
  const auto same = [&](std::uint32_t a, std::uint32_t b) { return degree(graph, a) == degree(graph, b); };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
  return sorted;
}

}  // namespace

PseudoDiameter pseudo_diameter(const CsrGraph& graph, LevelSearch& search, std::uint32_t start,
                               StepCounter& steps) {
  PseudoDiameter result{start, start, search(start)};
  bool deeper = true;
  while (deeper) {
    deeper = false;
    std::uint32_t narrowest = std::numeric_limits<std::uint32_t>::max();
    for (const std::uint32_t candidate : one_of_each_degree(graph, search.last_level())) {
      if (!steps.goes_on()) return result;
      if (const std::uint32_t depth = search(candidate); depth > result.depth) {
        result = {candidate, candidate, depth};
        deeper = true;  // its last level is at hand
        break;
      }
      if (search.width() < narrowest) {
        narrowest = search.width();
        result.to = candidate;
      }
    }
  }
  return result;
}

}  // namespace leonhard::graph::detail
