// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay triangulation of distinct points by divide and conquer: the points are sorted by x, halves
/// are triangulated on their own and merged by a rising bubble: a circle through the ends of one cross edge
/// grows upwards until it meets the point that makes the next one.
///
/// points  distinct and finite, in any order
/// Cost O(n log n) for every point set, a merge being linear in its points; 32 bytes an edge on the way.
/// Method: Guibas and Stolfi, ACM Transactions on Graphics 4 (1985), section 9, on their quad-edge structure
/// (Barth's notes 3.3a). A circle that passes through four points at once is decided by
/// kernel::incircle_perturbed: the perturbation depends on the points alone, so halves are perturbed as the
/// whole is, and the proof holds for the perturbed points.
[[nodiscard]] PointTriangulation triangulate_divide_and_conquer(std::span<const Point2> points,
                                                                const AlgorithmOptions& options = {});

}  // namespace leonhard::delaunay
