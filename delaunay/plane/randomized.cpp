// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/randomized.hpp"

#include "leonhard/delaunay/delaunay_tree.hpp"

namespace leonhard::delaunay {

PointTriangulation triangulate_randomized(std::span<const Point2> points, const AlgorithmOptions& options) {
  return DelaunayTree({points.begin(), points.end()}, options).release();
}

}  // namespace leonhard::delaunay
