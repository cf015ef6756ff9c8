// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay triangulation of distinct points inserted in random order, each located by the Delaunay tree
/// (DelaunayTree, which those use who want to ask it afterwards).
///
/// points  distinct and finite
/// Cost O(n log n) expected, whatever the points and their order.
/// Method: Guibas, Knuth and Sharir, Algorithmica 7 (1992) (Barth's notes 3.3c).
[[nodiscard]] PointTriangulation triangulate_randomized(std::span<const Point2> points,
                                                        const AlgorithmOptions& options = {});

}  // namespace leonhard::delaunay
