// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "leonhard/delaunay/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::delaunay {

/// Points sorted for insertion: equal ones merged, neighbours in the plane neighbours in memory.
struct SortedPoints {
  std::vector<Point2> points;               ///< distinct, along the Hilbert curve
  std::vector<std::uint32_t> first_input;   ///< one a point: the first input point there
  std::vector<std::uint32_t> sorted_index;  ///< one an input point: its point here
};

/// Sort and merge finite points. Cost O(n).
[[nodiscard]] SortedPoints sort_and_merge(std::span<const Point2> points);

struct IncrementalResult {
  enum class Outcome { done, too_few_points, all_collinear, stopped };
  Outcome outcome = Outcome::done;
  GhostTriangulation triangulation;
};

/// The Delaunay triangulation of distinct points, ties broken by kernel::incircle_perturbed: the same triangles for
/// every order of the points.
///
/// points  distinct and finite, best in Hilbert order
/// Cost O(n log n) expected for every distribution (the rounds are random), O(n) in practice.
/// Method: Bowyer 1981 and Watson 1981 (Barth's notes 3.3b) on a triangulation with a ghost vertex; points come in
/// rounds of eightfold size, each along the Hilbert curve (Amenta, Choi and Rote, SoCG 2003), located by walking
/// from the one before.
[[nodiscard]] IncrementalResult triangulate_incrementally(std::span<const Point2> points,
                                                          const Progress& progress);

}  // namespace leonhard::delaunay
