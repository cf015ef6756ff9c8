// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay triangulation of distinct points as the dual of their Voronoi diagram, into which one site
/// after another is inserted (BowyerDiagram).
///
/// points  distinct and finite, best in Hilbert order
/// Cost O(n) in practice; O(n^2) at worst, as the way to the nearest site has no better bound.
/// Method: Bowyer, "Computing Dirichlet tessellations", Computer Journal 24 (1981) (Barth's notes 3.3b), with
/// a point at infinity for unbounded edges; sites come in rounds of eightfold size, each along the Hilbert
/// curve (order_in_rounds), the nearest site found from the one inserted before.
[[nodiscard]] PointTriangulation triangulate_bowyer(std::span<const Point2> points,
                                                    const AlgorithmOptions& options = {});

}  // namespace leonhard::delaunay
