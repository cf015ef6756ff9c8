// SPDX-License-Identifier: MIT
#include "leonhard/graph/ordering.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Breadth-first level structures from many roots with one mark array: marks are compared with a stamp, so a
/// new search needs no clearing.
class LevelSearch {
 public:
  explicit LevelSearch(const CsrGraph& graph) : graph_(graph), stamp_(vertex_count(graph), 0) {}

  struct Levels {
    std::uint32_t depth{};         ///< number of levels less one: the root's eccentricity
    std::uint32_t least_degree{};  ///< vertex of least degree in the last level, smallest index
  };

  Levels operator()(std::uint32_t root) {
    ++current_;
    queue_.assign(1, root);
    stamp_[root] = current_;
    std::size_t level_begin = 0, level_end = 1;
    std::uint32_t depth = 0;
    while (true) {
      for (std::size_t i = level_begin; i < level_end; ++i) visit_neighbours(queue_[i]);
      if (queue_.size() == level_end) break;
      level_begin = level_end;
      level_end = queue_.size();
      ++depth;
    }
    return {depth, least_degree(std::span(queue_).subspan(level_begin))};
  }

  /// The vertex of least degree in root's component, smallest index.
  std::uint32_t least_degree_around(std::uint32_t root) {
    static_cast<void>((*this)(root));
    return least_degree(queue_);
  }

 private:
  [[nodiscard]] std::uint32_t least_degree(std::span<const std::uint32_t> vertices) const {
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
      const std::uint32_t da = degree(graph_, a), db = degree(graph_, b);
      return da != db ? da < db : a < b;
    };
    return *std::ranges::min_element(vertices, before);
  }

  void visit_neighbours(std::uint32_t v) {
    for (const std::uint32_t w : neighbours(graph_, v))
      if (stamp_[w] != current_) {
        stamp_[w] = current_;
        queue_.push_back(w);
      }
  }

  const CsrGraph& graph_;
  std::vector<std::uint32_t> stamp_;  ///< per vertex: the last search that reached it
  std::vector<std::uint32_t> queue_;
  std::uint32_t current_ = 0;
};

std::uint32_t pseudo_peripheral(LevelSearch& search, std::uint32_t start) {
  std::uint32_t root = start;
  LevelSearch::Levels levels = search(root);
  while (true) {
    const std::uint32_t candidate = levels.least_degree;
    const LevelSearch::Levels deeper = search(candidate);
    if (deeper.depth <= levels.depth) return candidate;
    root = candidate;
    levels = deeper;
  }
}

/// Appends the Cuthill-McKee sequence of root's component to order; placed marks what is in it.
void append_cuthill_mckee(const CsrGraph& graph, std::uint32_t root, std::vector<char>& placed,
                          std::vector<std::uint32_t>& order) {
  std::size_t next = order.size();
  order.push_back(root);
  placed[root] = 1;
  for (; next < order.size(); ++next) {
    const std::size_t first_child = order.size();
    for (const std::uint32_t w : neighbours(graph, order[next]))
      if (!placed[w]) {
        placed[w] = 1;
        order.push_back(w);
      }
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(first_child), order.end(),
              [&](std::uint32_t a, std::uint32_t b) {
                const std::uint32_t da = degree(graph, a), db = degree(graph, b);
                return da != db ? da < db : a < b;
              });
  }
}

}  // namespace

std::uint32_t pseudo_peripheral_vertex(const CsrGraph& graph, std::uint32_t start) {
  if (start >= vertex_count(graph))
    throw InputError("start",
                     "vertex " + std::to_string(start) + " does not exist, the graph has " +
                         std::to_string(vertex_count(graph)) + " vertices",
                     "start at one of them");
  LevelSearch search(graph);
  return pseudo_peripheral(search, start);
}

std::vector<std::uint32_t> reverse_cuthill_mckee(const CsrGraph& graph) {
  const std::uint32_t n = vertex_count(graph);
  std::vector<std::uint32_t> order;
  order.reserve(n);
  std::vector<char> placed(n, 0);
  LevelSearch search(graph);
  for (std::uint32_t v = 0; v < n; ++v)
    if (!placed[v])
      append_cuthill_mckee(graph, pseudo_peripheral(search, search.least_degree_around(v)), placed, order);
  std::ranges::reverse(order);
  return order;
}

std::vector<std::uint32_t> invert(std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> new_of_old(order.size(), none);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t old = order[i];
    if (old >= order.size() || new_of_old[old] != none)
      throw InputError("order",
                       "number " + std::to_string(old) + " at position " + std::to_string(i) +
                           (old >= order.size() ? " is out of range" : " is repeated"),
                       "give each of 0 ... " + std::to_string(order.size() - 1) + " once");
    new_of_old[old] = static_cast<std::uint32_t>(i);
  }
  return new_of_old;
}

OrderingCost ordering_cost(const CsrGraph& graph, std::span<const std::uint32_t> order) {
  const std::uint32_t n = vertex_count(graph);
  if (order.size() != n)
    throw InputError("order",
                     std::to_string(order.size()) + " numbers for " + std::to_string(n) + " vertices",
                     "give one a vertex");
  const std::vector<std::uint32_t> new_of_old = invert(order);
  OrderingCost cost;
  std::vector<std::uint32_t> rows_opened(n, 0);  // per step: the rows whose first column it is
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t first = i;
    for (const std::uint32_t w : neighbours(graph, order[i])) first = std::min(first, new_of_old[w]);
    cost.bandwidth = std::max(cost.bandwidth, i - first);
    cost.envelope += i - first;
    ++rows_opened[first];
  }
  std::uint32_t active = 0;  // each step opens the rows that begin there and closes its own
  double sum_of_squares = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    active += rows_opened[i];
    sum_of_squares += static_cast<double>(active) * active;
    --active;
  }
  cost.rms_wavefront = n == 0 ? 0 : std::sqrt(sum_of_squares / n);
  return cost;
}

std::vector<std::uint32_t> natural_order(const CsrGraph& graph) {
  std::vector<std::uint32_t> order(vertex_count(graph));
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

}  // namespace leonhard::graph
