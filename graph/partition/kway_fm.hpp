// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "leonhard/graph/multilevel/gain_queue.hpp"
#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/multilevel/kway_random.hpp"

namespace leonhard::graph::detail {

/// Refines a partition into any number of parts by moving single vertices.
class KwayFm {
 public:
  /// graph, part_of  must outlive the refiner; part_of is changed in place
  /// limit           no part shall weigh more
  KwayFm(const KwayGraph& graph, std::uint32_t parts, std::int64_t limit, std::vector<std::uint32_t>& part_of,
         Random& random);

  /// Moves vertices out of parts that are too heavy, at the least cost to the cut that single moves allow.
  ///
  /// returns  whether every part now keeps the limit; with vertices of one weight always, if parts * limit is enough
  bool rebalance();

  /// One round of small searches, each from a vertex of the boundary (in later rounds, near what moved in the round
  /// before): the search moves it and what is near, the best
  /// first and worse moves included, until that looks fruitless, and goes back to its best moment. A vertex is moved
  /// once at most in a round.
  ///
  /// patience  how many moves without a better cut end a search
  /// returns   by how much the cut became less
  /// Method: multi-try Fiduccia-Mattheyses, Sanders and Schulz, ESA 2011.
  std::int64_t search_round(std::uint32_t patience, const std::stop_token& stop);

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct Move {
    std::int32_t gain;
    std::uint32_t to;  ///< part, or none where there is no way
  };

  /// The best part beside v with room for it; among equals the lightest.
  [[nodiscard]] Move best_move(std::uint32_t v);
  [[nodiscard]] bool on_boundary(std::uint32_t v) const;
  void move(std::uint32_t v, std::uint32_t to);
  [[nodiscard]] std::vector<std::uint32_t> seeds();
  std::int32_t search(std::uint32_t seed, std::uint32_t patience);
  [[nodiscard]] std::uint32_t lightest_part() const;

  const KwayGraph& graph_;
  std::int64_t limit_;
  std::vector<std::uint32_t>& part_of_;
  Random& random_;
  std::vector<std::int64_t> weight_;      ///< per part
  std::vector<std::int32_t> connection_;  ///< per part: edges of the vertex at hand into it; 0 between calls
  std::vector<std::uint32_t> beside_;     ///< parts with such edges
  std::vector<char> moved_;               ///< per vertex: in this round
  GainQueue queue_;
  struct Step {
    std::uint32_t vertex, from;
  };
  std::vector<Step> steps_;
  bool first_round_ = true;
  std::vector<std::uint32_t> settled_;  ///< vertices that moved for good in the last round
};

}  // namespace leonhard::graph::detail
