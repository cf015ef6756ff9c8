// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "leonhard/mesh/draw/plane/scene.hpp"

namespace leonhard::draw {

/// The lines where a field, linear on each triangle, has the value `level`: polylines on the page, through the
/// visible triangles, closed ones ending where they start.
///
/// A vertex counts as above if its value is at or above the level, so that every triangle is crossed by no line or
/// by one, and lines end at the boundary only.
/// values  one a vertex. Cost O(visible triangles).
[[nodiscard]] std::vector<std::vector<Point2>> contour(const MeshScene& scene, std::span<const double> values,
                                                       double level);

/// The part of a triangle (page) where low <= value < high; values linear from those at the corners. At most five
/// corners; empty if there is none.
[[nodiscard]] std::vector<Point2> band_of(const std::array<Point2, 3>& corners,
                                          const std::array<double, 3>& values, double low, double high);

}  // namespace leonhard::draw
