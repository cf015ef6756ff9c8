// SPDX-License-Identifier: MIT
#include "leonhard/mesh/median_dual.hpp"

#include <array>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/same_mesh.hpp"
#include "leonhard/mesh/words.hpp"

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

/// The corners of a tetrahedron, as numbers, so that an edge of tet_edge_corners comes first and the order is even.
constexpr std::array<std::array<unsigned, 4>, 6> even_orders{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

/// 24 times the part of edge ab's dual face within the positive tetrahedron abcd, from a to b.
Vec3 face_part24(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return cross((c - a) + (d - b), d - c);
}

/// Twice a triangle's area, six times a tetrahedron's volume.
double determinant(const TriangleMesh& mesh, const std::array<VertexId, 3>& corners) {
  const Point2 a = mesh.points[corners[0]];
  return cross(mesh.points[corners[1]] - a, mesh.points[corners[2]] - a);
}
double determinant(const TetMesh& mesh, const std::array<VertexId, 4>& corners) {
  const Point3 a = mesh.points[corners[0]];
  return dot(cross(mesh.points[corners[1]] - a, mesh.points[corners[2]] - a), mesh.points[corners[3]] - a);
}

/// Of every cell each corner gets the same share.
template <int Dim>
PerId<VertexId, double> shares_of_cells(const SimplexMesh<Dim>& mesh) {
  constexpr double parts = Dim == 2 ? 6 : 24;
  PerId<VertexId, double> volume(mesh.vertex_count(), 0.0);
  for (const auto& corners : mesh.corners) {
    const double share = determinant(mesh, corners) / parts;
    for (const VertexId v : corners) volume[v] += share;
  }
  return volume;
}

}  // namespace

DualMetrics<2> median_dual(const TriangleMesh& mesh, const EdgeStructure& edges) {
  require_edges_of(mesh, edges);
  DualMetrics<2> dual;
  dual.normal.resize(edges.edge_count());
  for (const EdgeId e : edges.ends.ids())
    dual.normal[e] = turned_clockwise(dual_face(mesh, edges.ends[e], edges.sides[e]));
  dual.volume = shares_of_cells(mesh);
  dual.boundary_normal = boundary_normals(mesh);
  return dual;
}

DualMetrics<3> median_dual(const TetMesh& mesh, const TetEdges& edges) {
  require_edge_list_of(mesh, edges);
  require_boundary_within(mesh);
  DualMetrics<3> dual;
  dual.normal.resize(edges.edge_count());
  PerId<EdgeId, char> used(edges.edge_count(), 0);
  for (const auto& corners : mesh.corners) {
    const auto point = [&](unsigned i) { return mesh.points[corners[i]]; };
    for (const auto& [i, j, k, l] : even_orders) {
      const MaybeId<EdgeId> e = edges.find(corners[i], corners[j]);
      if (!e)
        throw InputError("edges", words(mesh, corners[i], corners[j]) + " is missing",
                         "give what build_edges makes of this mesh");
      used[*e] = 1;
      const Vec3 part = 1.0 / 24.0 * face_part24(point(i), point(j), point(k), point(l));
      Vec3& normal = dual.normal[*e];
      normal = corners[i] < corners[j] ? normal + part : normal - part;
    }
  }
  for (const EdgeId e : edges.ends.ids())
    if (!used[e]) throw_foreign_edge(e, edges.ends[e]);
  dual.volume = shares_of_cells(mesh);
  dual.boundary_normal = boundary_normals(mesh);
  return dual;
}

}  // namespace leonhard::mesh
