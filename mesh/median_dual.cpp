// SPDX-License-Identifier: MIT
#include "leonhard/mesh/median_dual.hpp"

#include "leonhard/mesh/check/same_mesh.hpp"

namespace leonhard::mesh {
namespace {

Vec2 turned_clockwise(Vec2 v) { return {v.y, -v.x}; }

/// Half of an edge's dual face within one triangle: the way from the edge's midpoint to the triangle's centroid,
/// (a + b + o)/3 - (a + b)/2, written in differences.
Vec2 midpoint_to_centroid(Point2 a, Point2 b, Point2 opposite) {
  return 1.0 / 6.0 * ((opposite - a) + (opposite - b));
}

Point2 opposite_corner(const TriangleMesh& mesh, TriangleId t, const std::array<VertexId, 2>& edge) {
  for (const VertexId v : mesh.corners[t]) {
    if (v != edge[0] && v != edge[1]) return mesh.points[v];
  }
  return mesh.points[edge[0]];  // not reached: a triangle of the edge has a third corner
}

/// The way along the dual face from the right triangle's centroid, by the edge's midpoint, to the left one's.
Vec2 dual_face(const TriangleMesh& mesh, const std::array<VertexId, 2>& ends,
               const std::array<MaybeId<TriangleId>, 2>& sides) {
  const Point2 a = mesh.points[ends[0]], b = mesh.points[ends[1]];
  if (sides[0] && sides[1]) {
    return 1.0 / 3.0 * (opposite_corner(mesh, *sides[0], ends) - opposite_corner(mesh, *sides[1], ends));
  }
  if (sides[0]) return midpoint_to_centroid(a, b, opposite_corner(mesh, *sides[0], ends));
  return -midpoint_to_centroid(a, b, opposite_corner(mesh, *sides[1], ends));
}

}  // namespace

MedianDual median_dual(const TriangleMesh& mesh, const EdgeStructure& edges) {
  require_edges_of(mesh, edges);
  MedianDual dual;
  dual.normal.resize(edges.edge_count());
  for (const EdgeId e : edges.ends.ids()) {
    dual.normal[e] = turned_clockwise(dual_face(mesh, edges.ends[e], edges.sides[e]));
  }

  dual.area.resize(mesh.vertex_count(), 0.0);
  for (const auto& [a, b, c] : mesh.corners) {
    const Point2 p = mesh.points[a];
    const double third = cross(mesh.points[b] - p, mesh.points[c] - p) / 6.0;
    dual.area[a] += third;
    dual.area[b] += third;
    dual.area[c] += third;
  }

  dual.boundary_normal.reserve(mesh.boundary.size());
  for (const MarkedEdge& edge : mesh.boundary) {
    dual.boundary_normal.push_back(turned_clockwise(mesh.points[edge.to] - mesh.points[edge.from]));
  }
  return dual;
}

}  // namespace leonhard::mesh
