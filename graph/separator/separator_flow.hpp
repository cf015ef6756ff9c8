// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/multilevel/local_flow.hpp"
#include "leonhard/graph/separator/separator_fm.hpp"

namespace leonhard::graph::detail {

/// Refines a separator: of all that lie within a strip on both sides of it, one of least weight, by a maximum flow
/// through the strip's vertices, where single moves would find the nearest.
///
/// Method: a vertex is an arc that carries its weight, an edge one without limit (Menger; Even and Tarjan, SIAM J.
/// Comput. 4 (1975) 507-518); the strip as in Sanders and Schulz, Advanced Multilevel Node Separator Algorithms (2016).
class SeparatorFlow {
 public:
  /// limit  of a side's weight; a separator that keeps it is not replaced by one that does not
  SeparatorFlow(const KwayGraph& graph, std::int64_t limit);

  /// depth  the strip weighs so many times the separator on each side, and no more than could change sides within the
  ///        limit
  /// returns  whether the separator became better
  bool improve(Sides& side, std::int64_t depth);

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  void grow_strip(const Sides& side, const SideWeights& weight, std::int64_t depth);
  [[nodiscard]] bool build_network(const Sides& side);
  [[nodiscard]] SideWeights weights_by(const Sides& side, const std::vector<std::uint32_t>& of_strip,
                                       SideWeights weight) const;

  const KwayGraph& graph_;
  std::int64_t limit_;
  std::vector<std::uint32_t> local_;  ///< per vertex: its number in the strip, or none
  std::vector<std::uint32_t> strip_;
  LocalFlow flow_;
};

}  // namespace leonhard::graph::detail
