// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "leonhard/kernel/point.hpp"

namespace leonhard::io {

/// Two edges of a closed polygon (edge i runs from point i to the next, the last to the first) that cross,
/// touch or overlap, or that are neighbours and fold back onto each other; the smaller index first. None: the
/// polygon is simple.
///
/// Decided by exact orient2d and comparisons. At least 3 points, no two consecutive ones equal.
/// Cost O(n log n) for curves of which a vertical line cuts few edges, as those of airfoils; O(n^2) at worst.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> edges_that_meet(
    std::span<const Point2> polygon);

/// Whether a simple polygon runs counter-clockwise: the turn at its lexicographically smallest point, exact.
[[nodiscard]] bool is_counter_clockwise(std::span<const Point2> simple_polygon);

}  // namespace leonhard::io
