// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/support/step_counter.hpp"

/// Breadth-first level structures, on which half of the orderings stand; not for callers outside this room.
namespace leonhard::graph::detail {

/// Level structures from many roots with one array of marks: marks are compared with a stamp, so that a new search
/// needs no clearing. What a search found stays until the next.
class LevelSearch {
 public:
  explicit LevelSearch(const CsrGraph& graph)
      : graph_(graph), stamp_(vertex_count(graph), 0), queue_(vertex_count(graph)) {}

  /// Search from a root; returns the number of levels less one: the root's eccentricity. Cost O(edges reached).
  std::uint32_t operator()(std::uint32_t root);

  /// The vertices reached, level after level.
  [[nodiscard]] std::span<const std::uint32_t> reached() const {
    return std::span(queue_).first(start_.back());
  }
  [[nodiscard]] std::uint32_t depth() const { return static_cast<std::uint32_t>(start_.size()) - 2; }
  [[nodiscard]] std::span<const std::uint32_t> level(std::uint32_t l) const {
    return reached().subspan(start_[l], start_[l + 1] - start_[l]);
  }
  [[nodiscard]] std::span<const std::uint32_t> last_level() const { return level(depth()); }
  /// Vertices of the largest level.
  [[nodiscard]] std::uint32_t width() const;
  /// To each vertex reached its level; others keep their value.
  void write_levels(std::span<std::uint32_t> level_of) const;

 private:
  const CsrGraph& graph_;
  std::vector<std::uint32_t> stamp_;  ///< per vertex: the last search that reached it
  std::vector<std::uint32_t> queue_;  ///< the vertices reached, then room for the others
  std::vector<std::uint32_t> start_;  ///< per level its place in the queue, and the end
  std::uint32_t current_ = 0;
};

/// The vertex of least degree among some, smallest index; there must be one.
[[nodiscard]] std::uint32_t least_degree(const CsrGraph& graph, std::span<const std::uint32_t> vertices);

/// All vertices by degree, then index. Cost O(n + largest degree).
[[nodiscard]] std::vector<std::uint32_t> vertices_by_degree(const CsrGraph& graph);

/// pseudo_peripheral_vertex with the search's memory.
[[nodiscard]] std::uint32_t pseudo_peripheral(const CsrGraph& graph, LevelSearch& search,
                                              std::uint32_t start);

/// Two ends of a graph: vertices about as far from one another as any two, both with narrow level structures.
struct PseudoDiameter {
  std::uint32_t from, to;
  std::uint32_t depth;  ///< their distance
};

/// Of start's component. Of the last level one vertex of each degree is tried.
///
/// steps  asked before each search; once stopped the ends are any two vertices
/// Method: Gibbs, Poole and Stockmeyer, SIAM J. Numer. Anal. 13 (1976) 236-250, algorithm I.
[[nodiscard]] PseudoDiameter pseudo_diameter(const CsrGraph& graph, LevelSearch& search, std::uint32_t start,
                                             StepCounter& steps);

}  // namespace leonhard::graph::detail
