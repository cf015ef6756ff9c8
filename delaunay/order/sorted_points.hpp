// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// Points sorted for triangulation: equal ones merged, neighbours in the plane neighbours in memory.
struct SortedPoints {
  std::vector<Point2> points;               ///< distinct, neighbours mostly side by side
  std::vector<std::uint32_t> first_input;   ///< one a point: the first input point there
  std::vector<std::uint32_t> sorted_index;  ///< one an input point: its point here
};

/// Sort and merge finite points. Cost O(n).
[[nodiscard]] SortedPoints sort_and_merge(std::span<const Point2> points);

}  // namespace leonhard::delaunay
