// SPDX-License-Identifier: MIT
#include "leonhard/mesh/exact_volume.hpp"

#include "leonhard/mesh/exact_sum.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/structures/sorted_facet.hpp"

namespace leonhard::mesh {
namespace {

void add_face(ExactSum& sum, const TetMesh& mesh, const std::array<VertexId, 3>& face) {
  sum.add_determinant(mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]);
}

}  // namespace

mpq_class exact_volume6(const TetMesh& mesh) {
  require_corners_in_range(mesh);
  ExactSum sum;
  for (const auto& corners : mesh.corners) {
    for (std::size_t side = 0; side < 4; ++side) add_face(sum, mesh, outward_facet(corners, side));
  }
  return sum.value();
}

mpq_class exact_boundary_volume6(const TetMesh& mesh) {
  require_boundary_in_range(mesh);
  ExactSum sum;
  for (const MarkedFace& face : mesh.boundary) add_face(sum, mesh, face.corners);
  return sum.value();
}

}  // namespace leonhard::mesh
