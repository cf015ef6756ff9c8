// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "leonhard/graph/multilevel/gain_queue.hpp"
#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/separator/vertex_separator.hpp"

namespace leonhard::graph::detail {

/// To each vertex its side, 0 or 1, or `middle`: the separator. No edge joins the sides.
using Sides = std::vector<std::uint32_t>;

constexpr std::uint32_t middle = VertexSeparator::separator;

/// The weights of the two sides and of the separator.
using SideWeights = std::array<std::int64_t, 3>;

[[nodiscard]] SideWeights weights_of(const KwayGraph& graph, const Sides& side);

/// How good a separator is: first the excess of a side over its limit, then its weight, then the sides' difference.
/// Less is better.
struct SeparatorQuality {
  std::int64_t excess, weight, difference;
  friend auto operator<=>(const SeparatorQuality&, const SeparatorQuality&) = default;
};

[[nodiscard]] SeparatorQuality quality_of(const SideWeights& weight, std::int64_t limit);

/// Moves vertices out of a separator. A vertex that goes to one side pulls its neighbours on the other side into the
/// separator; its gain is its weight less theirs. A pass moves each vertex once at most, worse moves included, and is
/// taken back to its best moment.
///
/// Method: Ashcraft and Liu, SIAM J. Matrix Anal. Appl. 19 (1998) 325-354; Hendrickson and Rothberg, SIAM J. Sci.
/// Comput. 20 (1998) 468-489; in the manner of Fiduccia and Mattheyses.
class SeparatorFm {
 public:
  /// limit  of a side's weight
  SeparatorFm(const KwayGraph& graph, std::int64_t limit);

  SeparatorQuality refine(Sides& side);

 private:
  struct Change {
    std::uint32_t vertex, from;
  };

  bool pass();
  [[nodiscard]] int next_side() const;
  void move(std::uint32_t to);
  void put(std::uint32_t v, std::uint32_t to);
  void file(std::uint32_t v);

  const KwayGraph& graph_;
  std::int64_t limit_;
  Sides* side_ = nullptr;
  SideWeights weight_{};
  std::array<GainQueue, 2> queue_;  ///< the separator's vertices that may move, by the side they would go to
  std::vector<char> moved_;         ///< per vertex: left the separator in this pass
  std::vector<Change> changes_;     ///< of this pass
};

}  // namespace leonhard::graph::detail
