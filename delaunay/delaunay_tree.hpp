// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/delaunay/plane/triangle_history.hpp"
#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/delaunay/topology/locate.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// A Delaunay triangulation with the history of its construction, the Delaunay tree of Guibas, Knuth and
/// Sharir (Algorithmica 7, 1992; Barth's notes 3.3c), which locates points and finds nearest sites exactly.
///
/// Queries are const and change nothing hidden: any number of threads may ask at once.
class DelaunayTree {
 public:
  /// Insert the points in a given order, a permutation, by Green and Sibson's method; each is located by the
  /// tree. Cost O(n log n) expected if the order is random, O(n^2) at worst.
  ///
  /// points  distinct and finite
  /// throws  InputError naming a point that is not finite or equal to an earlier one, and for an order that is no permutation
  DelaunayTree(std::vector<Point2> points, std::vector<std::uint32_t> order, const Progress& progress = {});
  /// The same in a random order of the seed.
  explicit DelaunayTree(std::vector<Point2> points, const AlgorithmOptions& options = {});

  /// What became of the construction. Unless it is done, the triangulation is empty, and locate and nearest throw
  /// InputError.
  [[nodiscard]] TriangulateOutcome outcome() const { return outcome_; }
  [[nodiscard]] const std::vector<Point2>& points() const { return points_; }
  [[nodiscard]] const GhostTriangulation& triangulation() const { return triangulation_; }
  [[nodiscard]] const TriangleHistory& history() const { return history_; }
  /// The order in which the points were inserted.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  /// Triangles ever made, ghost triangles among them, the first one and its ghosts not counted. Expected
  /// below 9 n for a random order, of which below 6 n outlive the insertion that made them.
  [[nodiscard]] std::size_t structural_changes() const { return structural_changes_; }
  /// The triangulation alone, moved out of the tree.
  [[nodiscard]] PointTriangulation release() && { return {outcome_, std::move(triangulation_)}; }

  /// Where a finite point lies; InputError for others. Cost O(log n) on the average over random orders.
  [[nodiscard]] Location locate(Point2 p) const;

  /// The site nearest to a finite point, the lexicographically first of those equally near.
  ///
  /// Method: among Delaunay neighbours one that is nearer, from a corner of the triangle that holds p; where
  /// there is none, no other site is nearer either (Barth's notes 3.2, property 6, for p as a site). Cost
  /// that of locate and of the steps, few for points that lie among the sites, but up to O(n).
  [[nodiscard]] VertexId nearest(Point2 p) const;

 private:
  void build(const Progress& progress);

  std::vector<Point2> points_;
  std::vector<std::uint32_t> order_;
  TriangulateOutcome outcome_ = TriangulateOutcome::done;
  GhostTriangulation triangulation_;
  TriangleHistory history_;
  std::size_t structural_changes_ = 0;
};

}  // namespace leonhard::delaunay
