// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/delaunay/order/insert_in_order.hpp"
#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay triangulation of distinct points by incremental insertion: the triangles whose circumcircles
/// hold the new point are removed, and the cavity is joined to it.
///
/// points  distinct and finite, best in Hilbert order
/// Cost O(n log n) expected for every distribution (the rounds are random), O(n) in practice.
/// Method: Watson, Computer Journal 24 (1981), and Bowyer's of the same issue seen in the triangles (Barth's
/// notes 3.3b), with a ghost vertex; points come in rounds of eightfold size, each along the Hilbert curve
/// (order_in_rounds), located by walking from the one before.
[[nodiscard]] PointTriangulation triangulate_watson(std::span<const Point2> points,
                                                    const AlgorithmOptions& options = {});

/// The same with the points taken in a given order, a permutation. Cost O(n^2) at worst: a bad order makes
/// that many structural changes (Barth's notes 3.3b and figure 3.3.8) or walks that far.
[[nodiscard]] Construction insert_watson(std::span<const Point2> points, std::vector<std::uint32_t> order,
                                         const Progress& progress = {});

}  // namespace leonhard::delaunay
