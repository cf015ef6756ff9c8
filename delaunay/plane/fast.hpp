// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/delaunay/order/cut_order.hpp"
#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay triangulation by divide and conquer along nested cuts, alternately by x and by y: the default algorithm.
///
/// Most merges are of a few points, and their triangles lie side by side in memory; a bubble's step costs two
/// orientations and up to three incircle tests, filtered together. Parts that no cut connects are made by
/// different threads; numbers of triangles depend on the points alone.
/// Cost O(n log n) at worst, O(n) for points spread evenly, beyond the sort. 48 bytes a point.
/// Method: Guibas and Stolfi, ACM Transactions on Graphics 4 (1985); cuts in turn by x and y: Dwyer, Algorithmica 2
/// (1987); triangles with ghosts: Shewchuk, "Triangle", Applied Computational Geometry (1996).
[[nodiscard]] PointTriangulation triangulate_fast(const CutOrder& order, const AlgorithmOptions& options);

/// The same for distinct, finite points in any order: sorts them, and numbers vertices as the points given.
[[nodiscard]] PointTriangulation triangulate_fast(std::span<const Point2> points,
                                                  const AlgorithmOptions& options = {});

}  // namespace leonhard::delaunay
