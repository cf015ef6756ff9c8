// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/delaunay/algorithm.hpp"
#include "leonhard/delaunay/order/sorted_points.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// Points in an order that suits an algorithm, and its triangulation of them.
struct [[nodiscard]] SortedTriangulation {
  SortedPoints sorted;       ///< empty where the work was stopped
  PointTriangulation cells;  ///< its vertices are the sorted points
};

/// Sort and merge finite points, then triangulate them.
SortedTriangulation sort_and_triangulate(std::span<const Point2> points, Algorithm algorithm,
                                         const AlgorithmOptions& options);

}  // namespace leonhard::delaunay
