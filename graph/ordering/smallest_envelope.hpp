// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "leonhard/graph/ordering.hpp"

namespace leonhard::graph::detail {

/// Of the orders offered to it, and their reverses, the one of the smallest envelope, the first among equals. Not for
/// callers outside this room.
class SmallestEnvelope {
 public:
  explicit SmallestEnvelope(const CsrGraph& graph) : graph_(graph) {}

  /// An order cut short counts only as long as there is no whole one.
  void offer(std::vector<std::uint32_t> order) {
    if (order.size() < vertex_count(graph_)) {
      if (best_.empty()) best_ = std::move(order);
      return;
    }
    order = better_direction(graph_, std::move(order));
    const std::uint64_t envelope = ordering_cost(graph_, order).envelope;
    if (envelope >= least_) return;
    least_ = envelope;
    best_ = std::move(order);
  }
  [[nodiscard]] std::vector<std::uint32_t> take() { return std::move(best_); }

 private:
  const CsrGraph& graph_;
  std::vector<std::uint32_t> best_;
  std::uint64_t least_ = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace leonhard::graph::detail
