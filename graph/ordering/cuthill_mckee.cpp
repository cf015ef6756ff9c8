// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "leonhard/graph/ordering.hpp"
#include "leonhard/graph/ordering/level_search.hpp"
#include "leonhard/graph/support/row_prefetch.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

/// Cuthill and McKee's sequence of one component after another.
class CuthillMcKee {
 public:
  explicit CuthillMcKee(const CsrGraph& graph) : graph_(graph), placed_(vertex_count(graph), 0) {
    order_.reserve(vertex_count(graph));
  }

  [[nodiscard]] bool is_placed(std::uint32_t v) const { return placed_[v] != 0; }

  /// Append root's component, breadth first, neighbours by increasing degree, ties by index.
  void append(std::uint32_t root) {
    std::size_t next = order_.size();
    order_.push_back(root);
    placed_[root] = 1;
    for (; next < order_.size(); ++next) {
      detail::prefetch_rows(graph_, order_, next, [&](std::uint32_t w) {
        __builtin_prefetch(&placed_[w], 1);
        __builtin_prefetch(&graph_.rows().offsets()[w]);
      });
      append_children(order_[next]);
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> take() { return std::move(order_); }

 private:
  void append_children(std::uint32_t v) {
    children_.clear();
    for (const std::uint32_t w : neighbours(graph_, v))
      if (placed_[w] == 0) {
        placed_[w] = 1;
        children_.push_back((std::uint64_t{degree(graph_, w)} << 32) | w);
      }
    if (children_.size() > 1) std::sort(children_.begin(), children_.end());
    for (const std::uint64_t child : children_) order_.push_back(static_cast<std::uint32_t>(child));
  }

  const CsrGraph& graph_;
  std::vector<char> placed_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint64_t> children_;  ///< degree, then vertex
};

}  // namespace

std::uint32_t pseudo_peripheral_vertex(const CsrGraph& graph, std::uint32_t start) {
  if (start >= vertex_count(graph))
    throw InputError("start",
                     "vertex " + std::to_string(start) + " does not exist, the graph has " +
                         std::to_string(vertex_count(graph)) + " vertices",
                     "start at one of them");
  detail::LevelSearch search(graph);
  return detail::pseudo_peripheral(graph, search, start);
}

std::vector<std::uint32_t> cuthill_mckee(const CsrGraph& graph) {
  CuthillMcKee sequence(graph);
  for (const std::uint32_t v :
       detail::vertices_by_degree(graph))  // the first of a component has its least degree
    if (!sequence.is_placed(v)) sequence.append(v);
  return sequence.take();
}

std::vector<std::uint32_t> reverse_cuthill_mckee(const CsrGraph& graph) {
  CuthillMcKee sequence(graph);
  detail::LevelSearch search(graph);
  for (const std::uint32_t v : detail::vertices_by_degree(graph))
    if (!sequence.is_placed(v)) sequence.append(detail::pseudo_peripheral(graph, search, v));
  std::vector<std::uint32_t> order = sequence.take();
  std::ranges::reverse(order);
  return order;
}

}  // namespace leonhard::graph
