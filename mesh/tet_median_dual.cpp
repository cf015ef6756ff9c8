// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_median_dual.hpp"

#include <array>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/same_mesh.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

/// The corners of a tetrahedron, as numbers, so that an edge of tet_edge_corners comes first and the order is even.
constexpr std::array<std::array<unsigned, 4>, 6> even_orders{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

/// 24 times the part of edge ab's dual face within the positive tetrahedron abcd, from a to b.
Vec3 face_part24(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return cross((c - a) + (d - b), d - c);
}

void add_tet(const TetMesh& mesh, const TetEdges& edges, const std::array<VertexId, 4>& corners,
             PerId<EdgeId, char>& used, TetDualMetrics& dual) {
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
  const Point3 a = point(0);
  const double quarter = dot(cross(point(1) - a, point(2) - a), point(3) - a) / 24.0;
  for (const VertexId v : corners) dual.volume[v] += quarter;
}

}  // namespace

TetDualMetrics median_dual(const TetMesh& mesh, const TetEdges& edges) {
  require_edge_list_of(mesh, edges);
  require_boundary_within(mesh);
  TetDualMetrics dual;
  dual.normal.resize(edges.edge_count(), Vec3{});
  dual.volume.resize(mesh.vertex_count(), 0.0);
  PerId<EdgeId, char> used(edges.edge_count(), 0);
  for (const auto& corners : mesh.corners) add_tet(mesh, edges, corners, used, dual);
  for (const EdgeId e : edges.ends.ids())
    if (!used[e]) throw_foreign_edge(e, edges.ends[e]);

  dual.boundary_normal.reserve(mesh.boundary.size());
  for (const MarkedFace& face : mesh.boundary) {
    const Point3 a = mesh.points[face.corners[0]];
    dual.boundary_normal.push_back(0.5 *
                                   cross(mesh.points[face.corners[1]] - a, mesh.points[face.corners[2]] - a));
  }
  return dual;
}

}  // namespace leonhard::mesh
