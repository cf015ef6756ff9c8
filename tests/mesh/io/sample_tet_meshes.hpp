// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

#include "leonhard/mesh/structures/sorted_facet.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/io/sample_meshes.hpp"
#include "tests/mesh/tet_shelf.hpp"

namespace leonhard::test {

/// 48 tetrahedra whose coordinates need all digits, with everything a TetMesh can carry: two boundary markers,
/// interfaces, whole regions, vertex markers, names.
inline TetMesh box_with_everything() {
  TetMesh mesh = tet_shelf::shaken_box(2, 7);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) mesh.boundary[i].marker = i % 3 == 0 ? 7 : 3;
  for (const TetId t : mesh.corners.ids())
    for (std::size_t side = 0; side < 4; ++side)
      if (const auto n = mesh.neighbours[t][side]; n && (*n).raw > t.raw && t.raw % 5 == 0)
        mesh.interfaces.push_back(
            {mesh::outward_facet(mesh.corners[t], side), static_cast<Marker>(11 + side)});
  for (const TetId t : mesh.corners.ids()) mesh.regions[t] = static_cast<double>(t.index() / 4 % 3);
  for (const VertexId v : mesh.points.ids()) mesh.vertex_markers[v] = static_cast<Marker>(v.index()) - 4;
  mesh.marker_names = {{3, "wall"}, {7, "far field"}, {12, "membrane"}, {99, "nowhere"}};
  REQUIRE(mesh.interfaces.size() > 3);
  REQUIRE_FALSE(mesh::validate(mesh));
  return mesh;
}

/// One tetrahedron below (vertices 0, 1, 2, 3) and one above the face 1-2-3.
inline TetMesh two_tets() {
  return tet_shelf::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                          {{0, 1, 2, 3}, {1, 2, 3, 4}});
}

inline std::vector<MarkedFace> sorted(std::vector<MarkedFace> faces) {
  std::sort(faces.begin(), faces.end(), [](const MarkedFace& a, const MarkedFace& b) {
    return std::tie(a.corners, a.marker) < std::tie(b.corners, b.marker);
  });
  return faces;
}

/// Points to the last bit, tetrahedra, neighbours, boundary with markers, and names.
inline void check_same_geometry_and_boundary(const TetMesh& a, const TetMesh& b) {
  CHECK(a.points == b.points);
  CHECK(a.corners == b.corners);
  CHECK(a.neighbours == b.neighbours);
  CHECK(sorted(a.boundary) == sorted(b.boundary));
  CHECK(a.marker_names == b.marker_names);
  CHECK(mesh::fingerprint(a) == mesh::fingerprint(b));
  CHECK_FALSE(mesh::validate(b));
}

}  // namespace leonhard::test
