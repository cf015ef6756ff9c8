// SPDX-License-Identifier: MIT
#include "leonhard/mesh/faces.hpp"

#include <utility>

#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/structures/half_facets.hpp"

namespace leonhard {

MaybeId<FaceId> FaceStructure::find(VertexId a, VertexId b, VertexId c) const {
  return mesh::find_facet(corners, first_face, mesh::sorted_facet(std::array{a, b, c}).corners);
}

namespace mesh {

FaceStructure build_faces(const TetMesh& mesh) {
  auto [corners, sides, first] = facet_list(mesh, checked_half_facets(mesh));
  return {std::move(corners), std::move(sides), std::move(first)};
}

}  // namespace mesh
}  // namespace leonhard
