// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/delaunay/algorithm.hpp"

namespace leonhard::delaunay {

/// The Delaunay triangulation of distinct points by incremental insertion: the triangles whose circumcircles hold the
/// new point are removed, and the cavity is joined to it.
///
/// points  distinct and finite, best in Hilbert order
/// Cost O(n log n) expected for every distribution (the rounds are random), O(n) in practice.
/// Method: Bowyer 1981 and Watson 1981 (Barth's notes 3.3b) on a triangulation with a ghost vertex; points come in
/// rounds of eightfold size, each along the Hilbert curve (Amenta, Choi and Rote, SoCG 2003), located by walking
/// from the one before.
[[nodiscard]] PointTriangulation triangulate_watson(std::span<const Point2> points,
                                                    const AlgorithmOptions& options = {});

}  // namespace leonhard::delaunay
