// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/multilevel/kway_random.hpp"
#include "leonhard/graph/multilevel/local_flow.hpp"

namespace leonhard::graph::detail {

/// Refines a partition pair of parts by pair of parts: among all ways to share the vertices near their common boundary
/// it finds one of least cut, by a maximum flow, where single moves would find the nearest.
///
/// Method: Sanders and Schulz, ESA 2011.
class KwayFlow {
 public:
  /// How heavy a part should be and may be.
  struct Room {
    std::int64_t target, limit;
  };

  /// How wide the strip at a boundary is that a flow may change.
  struct Strip {
    double reach;        ///< 1: what could change sides within the limit; larger ones are tried first
    std::int64_t depth;  ///< on each side at most so many times the boundary's weight, see breadth
  };

  /// graph, part_of  must outlive the refiner; part_of is changed in place
  /// room            of each part; one that kept its limit before keeps it
  KwayFlow(const KwayGraph& graph, std::vector<Room> room, std::vector<std::uint32_t>& part_of,
           Random& random);

  /// Every pair of parts that touch once; in later rounds those of which one part changed in the round before.
  ///
  /// returns  by how much the cut became less
  std::int64_t round(const Strip& strip, const std::stop_token& stop);

 private:
  struct Pair {
    std::uint32_t a, b;                   ///< a < b
    std::vector<std::uint32_t> boundary;  ///< vertices of either with edges to the other
  };
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] std::vector<Pair> touching_pairs();
  bool improve(const Pair& pair, const Strip& strip);
  [[nodiscard]] std::int64_t budget(std::uint32_t receiver, double reach) const;
  [[nodiscard]] std::int64_t breadth(std::uint32_t part, std::span<const std::uint32_t> boundary) const;
  [[nodiscard]] std::int64_t excess(const Pair& pair, std::int64_t weight_of_a) const;
  void grow_strip(std::span<const std::uint32_t> boundary, std::uint32_t part, std::int64_t budget);
  [[nodiscard]] std::int64_t build_network(std::uint32_t a, std::uint32_t b);

  const KwayGraph& graph_;
  std::uint32_t parts_;
  std::vector<Room> room_;  ///< per part
  std::vector<std::uint32_t>& part_of_;
  Random& random_;
  std::vector<std::int64_t> weight_;  ///< per part
  std::vector<char> active_;          ///< per part: changed in the last round
  std::vector<char> changed_;         ///< per part: in this round
  std::vector<std::uint32_t> local_;  ///< per vertex: its number in the strip, or none
  std::vector<std::uint32_t> strip_;
  LocalFlow flow_;
  std::int64_t gained_ = 0;
};

}  // namespace leonhard::graph::detail
