// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/delaunay/order/insert_in_order.hpp"
#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay triangulation of distinct points by incremental insertion and swapping.
///
/// points  distinct and finite, best in Hilbert order
/// Cost O(n log n) expected for every distribution (the rounds are random), O(n) in practice.
/// Method: Green and Sibson, "Computing Dirichlet tessellations in the plane", Computer Journal 21 (1978)
/// (Barth's notes 3.3b), with a ghost vertex (SwapInsertion); points come in rounds of eightfold size, each
/// along the Hilbert curve (order_in_rounds), located by walking from the one before.
[[nodiscard]] PointTriangulation triangulate_green_sibson(std::span<const Point2> points,
                                                          const AlgorithmOptions& options = {});

/// The same with the points taken in a given order, a permutation. Cost O(n^2) at worst: a bad order makes
/// that many structural changes (Barth's notes 3.3b and figure 3.3.8) or walks that far.
[[nodiscard]] Construction insert_green_sibson(std::span<const Point2> points,
                                               std::vector<std::uint32_t> order,
                                               const Progress& progress = {});

}  // namespace leonhard::delaunay
