// SPDX-License-Identifier: MIT
#include "leonhard/mesh/exact_area.hpp"

#include "leonhard/mesh/exact_sum.hpp"
#include "leonhard/mesh/ids_in_range.hpp"

namespace leonhard::mesh {
namespace {

void add_cross(ExactSum& sum, Point2 p, Point2 q) { sum.add_cross(p.x, p.y, q.x, q.y); }

}  // namespace

mpq_class exact_area2(const TriangleMesh& mesh) {
  require_corners_in_range(mesh);
  ExactSum sum;
  for (const auto& [a, b, c] : mesh.corners) {
    add_cross(sum, mesh.points[a], mesh.points[b]);
    add_cross(sum, mesh.points[b], mesh.points[c]);
    add_cross(sum, mesh.points[c], mesh.points[a]);
  }
  return sum.value();
}

mpq_class exact_boundary_area2(const TriangleMesh& mesh) {
  require_boundary_in_range(mesh);
  ExactSum sum;
  for (const MarkedEdge& edge : mesh.boundary) add_cross(sum, mesh.points[edge.from], mesh.points[edge.to]);
  return sum.value();
}

}  // namespace leonhard::mesh
