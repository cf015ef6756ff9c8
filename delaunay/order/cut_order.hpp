// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "leonhard/delaunay/order/sorted_points.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"

namespace leonhard::delaunay {

/// Points in an order in which nested cuts, alternately by x and by y, halve the plane: what divide and conquer divides.
struct CutOrder {
  SortedPoints sorted;
  /// One a point: the depth of the cut between it and the point before it. Of the points around the cut that no
  /// cut of smaller depth separates, those before it are all less than those after it: lexicographically by
  /// (x, y) where the depth is even, by (y, -x) where it is odd. cut_depth[0] has no meaning.
  std::vector<std::uint16_t> cut_depth;
};

/// Sort finite points by nested cuts and merge equal ones; none if a stop was requested.
///
/// threads  0: as many as there are cores; the answer does not depend on it
/// The cuts are those of a quadtree (Morton's order) over the bounding square, with a quadtree of their own in cells
/// that hold many points, and by x alone where cells that small would be of no use.
/// Cost O(n) for points that a quadtree of moderate depth separates, O(n log n) at worst. 18 bytes a point, with the
/// answer 42, while it runs.
[[nodiscard]] std::optional<CutOrder> sort_by_cuts(std::span<const Point2> points, unsigned threads,
                                                   const Progress& progress);

}  // namespace leonhard::delaunay
