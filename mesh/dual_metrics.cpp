// SPDX-License-Identifier: MIT
#include "leonhard/mesh/dual_metrics.hpp"

#include <string>
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/same_mesh.hpp"

namespace leonhard::mesh {
namespace {

Vec2 turned_clockwise(Vec2 v) { return {v.y, -v.x}; }

}  // namespace

std::vector<Vec2> boundary_normals(const TriangleMesh& mesh) {
  std::vector<Vec2> normals;
  normals.reserve(mesh.boundary.size());
  for (const MarkedEdge& edge : mesh.boundary)
    normals.push_back(turned_clockwise(mesh.points[edge.to] - mesh.points[edge.from]));
  return normals;
}

std::vector<Vec3> boundary_normals(const TetMesh& mesh) {
  std::vector<Vec3> normals;
  normals.reserve(mesh.boundary.size());
  for (const MarkedFace& face : mesh.boundary) {
    const Point3 a = mesh.points[face.corners[0]];
    normals.push_back(0.5 * cross(mesh.points[face.corners[1]] - a, mesh.points[face.corners[2]] - a));
  }
  return normals;
}

DualMetrics<2> straight_dual(const TriangleMesh& mesh, const EdgeStructure& edges,
                             const PerId<TriangleId, Point2>& centres) {
  require_edges_of(mesh, edges);
  if (centres.size() != mesh.triangle_count())
    throw InputError("centres",
                     std::to_string(centres.size()) + " centres for " +
                         std::to_string(mesh.triangle_count()) + " triangles",
                     "give one a triangle");
  DualMetrics<2> dual;
  dual.normal.resize(edges.edge_count());
  dual.volume.resize(mesh.vertex_count(), 0.0);
  for (const EdgeId e : edges.ends.ids()) {
    const auto& [a, b] = edges.ends[e];
    const auto& [left, right] = edges.sides[e];
    // The face's ends, to the right and to the left of a -> b, as seen from a: differences keep their digits.
    const Vec2 along = mesh.points[b] - mesh.points[a], middle = 0.5 * along;
    const Vec2 from = right ? centres[*right] - mesh.points[a] : middle;
    const Vec2 to = left ? centres[*left] - mesh.points[a] : middle;
    dual.normal[e] = turned_clockwise(to - from);
    dual.volume[a] += 0.5 * cross(from, to);
    dual.volume[b] += 0.5 * cross(to - along, from - along);
  }
  dual.boundary_normal = boundary_normals(mesh);
  return dual;
}

}  // namespace leonhard::mesh
