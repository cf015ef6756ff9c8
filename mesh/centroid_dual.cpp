// SPDX-License-Identifier: MIT
#include "leonhard/mesh/centroid_dual.hpp"
#include "leonhard/mesh/check/same_mesh.hpp"

namespace leonhard::mesh {

DualMetrics<2> centroid_dual(const TriangleMesh& mesh, const EdgeStructure& edges) {
  require_edges_of(mesh, edges);
  PerId<TriangleId, Point2> centroids(mesh.triangle_count());
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& [a, b, c] = mesh.corners[t];
    const Point2 p = mesh.points[a];
    centroids[t] = p + 1.0 / 3.0 * ((mesh.points[b] - p) + (mesh.points[c] - p));
  }
  return straight_dual(mesh, edges, centroids);
}

}  // namespace leonhard::mesh
