// SPDX-License-Identifier: MIT
#include "leonhard/mesh/faces.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/tet_invariants.hpp"
#include "leonhard/mesh/structures/half_faces.hpp"

namespace leonhard {

MaybeId<FaceId> FaceStructure::find(VertexId a, VertexId b, VertexId c) const {
  const auto face = mesh::sorted_face({a, b, c}).corners;
  if (face[0].index() + 1 >= first_face.size()) return {};
  const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(first_face[face[0].index()]);
  const auto end = corners.begin() + static_cast<std::ptrdiff_t>(first_face[face[0].index() + 1]);
  const auto at = std::lower_bound(begin, end, face);
  if (at == end || *at != face) return {};
  return FaceId::from(static_cast<std::size_t>(at - corners.begin()));
}

namespace mesh {
namespace {

void refuse(const std::optional<std::string>& problem) {
  if (problem) throw InputError("", *problem, "correct the list of tetrahedra");
}

}  // namespace

FaceStructure build_faces(const TetMesh& mesh) {
  refuse(broken_corner(mesh));
  const HalfFaceTable table = half_face_table(mesh);
  refuse(broken_face(mesh, table));

  FaceStructure faces;
  const std::size_t expected = table.entries.size() / 2 + mesh.boundary.size() / 2 + 1;
  faces.corners.reserve(expected);
  faces.sides.reserve(expected);
  faces.first_face.assign(mesh.vertex_count() + 1, 0);
  for_each_face_until(table, [&](VertexId low, std::span<const HalfFace> group) {
    faces.corners.push_back({low, group[0].middle, group[0].high});
    faces.sides.push_back({});
    for (const HalfFace& half : group) faces.sides.flat().back()[half.even ? 0 : 1] = half.tet;
    ++faces.first_face[low.index() + 1];
    return false;
  });
  for (std::size_t v = 1; v < faces.first_face.size(); ++v) faces.first_face[v] += faces.first_face[v - 1];
  return faces;
}

}  // namespace mesh
}  // namespace leonhard
