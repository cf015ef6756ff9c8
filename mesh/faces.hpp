// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard {

/// The edge structure of Barth's notes 1.3 extended to space, "facewise": of each face its three vertices and the two
/// tetrahedra that share it. A face on the boundary has one of them only. Faces are sorted by their vertices, so their
/// numbers depend on the vertices' numbers alone. 20 bytes a face.
struct FaceStructure {
  PerId<FaceId, std::array<VertexId, 3>> corners;  ///< ascending
  /// [0] the tetrahedron from outside of which the corners turn counter-clockwise, so that their normal leaves it;
  /// [1] the one which the normal enters
  PerId<FaceId, std::array<MaybeId<TetId>, 2>> sides;
  std::vector<IdRaw> first_face;  ///< faces with corners[0] == v are first_face[v] .. first_face[v + 1] - 1

  [[nodiscard]] std::size_t face_count() const { return corners.size(); }
  [[nodiscard]] bool is_boundary(FaceId f) const { return !sides[f][0] || !sides[f][1]; }

  /// The face of three vertices, given in any order; none if there is no such face. Cost O(log degree).
  [[nodiscard]] MaybeId<FaceId> find(VertexId a, VertexId b, VertexId c) const;
};

namespace mesh {

/// The face structure of a mesh, from its corners alone: neighbours and boundary are not read, so the counts are
/// independent of them.
///
/// throws  InputError as build_neighbours does
/// Cost O(vertices + tetrahedra), one sort by buckets.
[[nodiscard]] FaceStructure build_faces(const TetMesh& mesh);

}  // namespace mesh
}  // namespace leonhard
