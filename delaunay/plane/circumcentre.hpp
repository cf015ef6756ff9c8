// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "leonhard/delaunay/voronoi_corner.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// v scaled to length 1, whatever its length but 0.
[[nodiscard]] Vec2 unit(Vec2 v);

/// b - a, or half of it where that overflows.
[[nodiscard]] Vec2 towards(Point2 a, Point2 b);

/// The circumcentre of a triangle, not flat, as near as doubles can say.
[[nodiscard]] VoronoiCorner<Point2> rounded_circumcentre(const std::array<Point2, 3>& corners);

}  // namespace leonhard::delaunay
