// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "leonhard/graph/multilevel/kway_graph.hpp"
#include "leonhard/graph/multilevel/kway_random.hpp"

namespace leonhard::graph::detail {

/// Who is contracted with whom: vertices of one cluster become one.
struct Clusters {
  std::vector<std::uint32_t> cluster_of;  ///< one a vertex
  std::uint32_t count{};                  ///< clusters are 0 ... count-1, by their first vertices
};

/// Pairs of neighbours joined by heavy edges.
///
/// An edge is rated weight^2 / (product of its ends' weights), which keeps the coarse vertices of one size; vertices
/// choose in random sequence. If many find nobody, as the leaves of a star, those with one hub in common pair up.
///
/// largest  no pair weighs more
/// label    only vertices of one label are joined; empty: all are
/// Cost O(n + m). Method: heavy-edge matching, Karypis and Kumar, SIAM J. Sci. Comput. 20 (1998) 359-392; the rating
/// after Holtgrewe, Sanders and Schulz, IPDPS 2010.
[[nodiscard]] Clusters heavy_edge_matching(const KwayGraph& graph, std::int64_t largest,
                                           std::span<const std::uint32_t> label, Random& random);

/// The graph of the clusters: weights add up, edges within a cluster vanish.
///
/// Cost O(n + m).
[[nodiscard]] KwayGraph contract(const KwayGraph& graph, const Clusters& clusters);

/// How much heavier than on the finest level a part or a side may be on a coarse one, where vertices are too heavy to
/// meet a narrow bound: by the heaviest vertex. The way up takes that back little by little.
[[nodiscard]] std::int64_t allowance(const KwayGraph& coarse);

/// A graph coarsened step by step.
class Hierarchy {
 public:
  /// size    stops when a level has no more vertices than this, or shrinks no longer
  /// label   as above, of the finest level
  /// graph   must outlive the hierarchy
  Hierarchy(const KwayGraph& graph, std::uint32_t size, std::vector<std::uint32_t> label, Random& random,
            const std::stop_token& stop);

  [[nodiscard]] std::size_t levels() const { return coarse_.size() + 1; }
  [[nodiscard]] const KwayGraph& level(std::size_t depth) const {
    return depth == 0 ? *finest_ : coarse_[depth - 1].graph;
  }
  [[nodiscard]] const KwayGraph& coarsest() const { return level(levels() - 1); }

  /// To each vertex of level depth the value of its cluster in level depth + 1.
  [[nodiscard]] std::vector<std::uint32_t> project(std::size_t depth,
                                                   std::span<const std::uint32_t> values) const;
  /// The values of the finest level, equal within clusters, carried to the coarsest.
  [[nodiscard]] std::vector<std::uint32_t> to_coarsest(std::vector<std::uint32_t> values) const;

 private:
  struct Level {
    KwayGraph graph;
    std::vector<std::uint32_t> cluster_of;  ///< of the vertices of the finer level
  };
  const KwayGraph* finest_;
  std::vector<Level> coarse_;
};

}  // namespace leonhard::graph::detail
