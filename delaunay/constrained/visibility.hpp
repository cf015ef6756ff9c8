// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

using Wall = std::array<Point2, 2>;

/// Can some part of the edge ab be seen from p? A line of sight may not cross a wall nor touch it; what is
/// seen through a chink without width does not count.
///
/// p      not on the line ab
/// walls  segments that neither cross ab nor each other nor have p inside
/// Exact. Cost O(walls log walls), rational numbers only for walls between p and the edge.
[[nodiscard]] bool sees_edge(const Point2& p, const Point2& a, const Point2& b, std::span<const Wall> walls);

}  // namespace leonhard::delaunay
