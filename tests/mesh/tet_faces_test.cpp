// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/faces.hpp"
#include "leonhard/mesh/tet_edges.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

TEST_CASE("face_structure_has_every_face_once_in_order_with_the_tetrahedra_on_its_two_sides") {
  for (const auto& entry : tet_shelf::all()) {
    const TetMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    std::map<std::array<VertexId, 3>, std::vector<TetId>> expected;
    for (const TetId t : mesh.corners.ids()) {
      for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        std::vector<VertexId> f;
        for (std::size_t i = 0; i < 4; ++i)
          if (i != left_out) f.push_back(mesh.corners[t][i]);
        std::sort(f.begin(), f.end());
        expected[{f[0], f[1], f[2]}].push_back(t);
      }
    }
    const FaceStructure faces = mesh::build_faces(mesh);
    REQUIRE(faces.face_count() == expected.size());
    REQUIRE(faces.first_face.size() == mesh.vertex_count() + 1);
    CHECK(faces.first_face.back() == faces.face_count());
    auto at = expected.begin();
    for (const FaceId f : faces.corners.ids()) {
      const auto& [corners, tets] = *at++;
      REQUIRE(faces.corners[f] == corners);
      REQUIRE(faces.is_boundary(f) == (tets.size() == 1));
      const auto& [a, b, c] = corners;
      for (const std::size_t side : {0, 1}) {
        const auto t = faces.sides[f][side];
        if (!t) continue;
        REQUIRE(std::count(tets.begin(), tets.end(), *t) == 1);
        for (const VertexId v : mesh.corners[*t]) {
          if (v == a || v == b || v == c) continue;
          const Sign before =
              kernel::exact::orient3d(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[v]);
          REQUIRE(before == (side == 0 ? Sign::negative : Sign::positive));
        }
      }
      REQUIRE(faces.find(c, a, b) == MaybeId<FaceId>(f));
      REQUIRE(faces.find(b, a, c) == MaybeId<FaceId>(f));
    }
  }
}

TEST_CASE("find_knows_no_faces_and_edges_that_are_not_there") {
  const auto mesh = tet_shelf::box(2, 1, 1);
  const FaceStructure faces = mesh::build_faces(mesh);
  const TetEdges edges = mesh::build_edges(mesh);
  std::set<std::array<VertexId, 3>> known(faces.corners.begin(), faces.corners.end());
  const auto n = static_cast<IdRaw>(mesh.vertex_count());
  std::size_t found = 0;
  for (IdRaw a = 0; a < n + 2; ++a) {
    for (IdRaw b = 0; b < n + 2; ++b) {
      for (IdRaw c = 0; c < n + 2; ++c) {
        const bool is_face = faces.find(VertexId{a}, VertexId{b}, VertexId{c}).has_value();
        std::array ascending{VertexId{a}, VertexId{b}, VertexId{c}};
        std::sort(ascending.begin(), ascending.end());
        REQUIRE(is_face == known.contains(ascending));
      }
      found += edges.find(VertexId{a}, VertexId{b}).has_value();
    }
  }
  CHECK(found == 2 * edges.edge_count());
}

TEST_CASE("edges_are_the_pairs_of_corners_each_once_in_order") {
  for (const auto& entry : tet_shelf::all()) {
    const TetMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    std::set<std::array<VertexId, 2>> expected;
    for (const auto& corners : mesh.corners) {
      for (const VertexId a : corners) {
        for (const VertexId b : corners)
          if (a < b) expected.insert({a, b});
      }
    }
    const TetEdges edges = mesh::build_edges(mesh);
    REQUIRE(edges.ends.flat() == std::vector(expected.begin(), expected.end()));
    REQUIRE(edges.first_edge.size() == mesh.vertex_count() + 1);
    for (const EdgeId e : edges.ends.ids()) {
      const auto& [a, b] = edges.ends[e];
      REQUIRE(edges.find(a, b) == MaybeId<EdgeId>(e));
      REQUIRE(edges.find(b, a) == MaybeId<EdgeId>(e));
      REQUIRE(edges.first_edge[a.index()] <= e.index());
      REQUIRE(e.index() < edges.first_edge[a.index() + 1]);
    }
  }
}

TEST_CASE("build_faces_refuses_what_is_no_oriented_mesh") {
  auto mesh = tet_shelf::box(1, 1, 1);
  std::swap(mesh.corners[TetId{2}][0], mesh.corners[TetId{2}][1]);
  CHECK_THROWS_AS((void)mesh::build_faces(mesh), InputError);
  std::swap(mesh.corners[TetId{2}][0], mesh.corners[TetId{2}][1]);
  mesh.corners[TetId{2}][0] = VertexId{100};
  CHECK_THROWS_AS((void)mesh::build_faces(mesh), InputError);
}

TEST_CASE("faces_and_edges_of_no_mesh_are_none") {
  CHECK(mesh::build_faces(TetMesh{}).face_count() == 0);
  CHECK(mesh::build_edges(TetMesh{}).edge_count() == 0);
}
