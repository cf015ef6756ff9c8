// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "leonhard/graph/multilevel/bisection_goal.hpp"
#include "leonhard/graph/multilevel/gain_queue.hpp"
#include "leonhard/graph/multilevel/kway_graph.hpp"

namespace leonhard::graph::detail {

/// Refines bisections of one graph by moving single vertices, the best first, worse moves included: each pass moves a
/// vertex once at most, and is taken back to its best moment.
///
/// Method: Fiduccia and Mattheyses, DAC 1982, from the boundary only and with an early end of fruitless passes.
class TwoWayFm {
 public:
  /// graph  must outlive the refiner
  TwoWayFm(const KwayGraph& graph, const BisectionGoal& goal);

  /// side      changed in place
  /// returns   the weight of the cut edges
  /// Where a side was over its limit, the excess becomes less or stays; the cut may then grow.
  std::int64_t refine(std::vector<std::uint32_t>& side, std::uint32_t passes);

  /// How much the sides are over their limits together.
  [[nodiscard]] std::int64_t excess() const { return excess_if(weight_[0], 0) + excess_if(weight_[1], 1); }

 private:
  [[nodiscard]] std::int64_t excess_if(std::int64_t weight, std::uint32_t s) const {
    return weight > goal_.limit[s] ? weight - goal_.limit[s] : 0;
  }
  /// Edges to the other side less edges to the own one; on_boundary where there is one of the former.
  struct Gain {
    std::int32_t value;
    bool on_boundary;
  };
  [[nodiscard]] Gain gain(const std::vector<std::uint32_t>& side, std::uint32_t v) const;
  [[nodiscard]] std::uint32_t next_source() const;
  void fill_queues(const std::vector<std::uint32_t>& side);
  void move(std::vector<std::uint32_t>& side, std::uint32_t v);
  bool pass(std::vector<std::uint32_t>& side);

  const KwayGraph& graph_;
  BisectionGoal goal_;
  std::int64_t passing_excess_;          ///< allowed within a pass, so that vertices can change places
  std::array<GainQueue, 2> queue_;       ///< by side
  std::vector<std::uint32_t> moved_in_;  ///< per vertex: the last pass that moved or gave it up
  std::vector<std::uint32_t> moves_;
  std::array<std::int64_t, 2> weight_{};
  std::int64_t cut_ = 0;
  std::uint32_t pass_ = 0;
};

}  // namespace leonhard::graph::detail
