// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_data_structures.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

std::string refusal(const FaceStructure& faces, const PerId<VertexId, Point3>& points) {
  try {
    (void)mesh::tet_mesh(faces, points);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("mesh_to_faces_and_back_is_the_same_mesh_but_for_the_order_of_corners") {
  for (const auto& entry : tet_shelf::all()) {
    const TetMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const FaceStructure faces = mesh::build_faces(mesh);
    const TetMesh back = mesh::tet_mesh(faces, mesh.points, 4);
    CHECK(mesh::validate(back).value_or("") == "");
    CHECK(back.points == mesh.points);
    REQUIRE(back.tet_count() == mesh.tet_count());
    for (const TetId t : mesh.corners.ids()) {
      auto a = mesh.corners[t], b = back.corners[t];
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      REQUIRE(a == b);
    }
    const auto boundary = mesh::boundary_facets(mesh, 4);  // in the order of faces, too
    REQUIRE(back.boundary.size() == boundary.size());
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const auto& [a, b, c] = back.boundary[i].corners;
      const std::array turned{b, c, a}, again{c, a, b};
      const auto& expected = boundary[i].corners;
      REQUIRE((back.boundary[i].corners == expected || turned == expected || again == expected));
      REQUIRE(back.boundary[i].marker == 4);
    }
    CHECK(mesh::build_faces(back).sides == faces.sides);
    CHECK(mesh::fingerprint(back) == mesh::fingerprint(mesh));
  }
}

TEST_CASE("edges_of_faces_are_those_of_the_mesh") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const TetEdges of_mesh = mesh::build_edges(entry.mesh);
    const TetEdges of_faces = mesh::build_edges(mesh::build_faces(entry.mesh), entry.mesh.vertex_count());
    CHECK(of_faces.ends == of_mesh.ends);
    CHECK(of_faces.first_edge == of_mesh.first_edge);
  }
}

TEST_CASE("faces_that_do_not_make_tetrahedra_are_refused") {
  const auto mesh = tet_shelf::box(2, 1, 1);
  const auto good = mesh::build_faces(mesh);
  CHECK(refusal(good, mesh.points).empty());
  const auto says = [&](const std::function<void(FaceStructure&)>& spoil, const char* words) {
    auto faces = good;
    spoil(faces);
    const std::string text = refusal(faces, mesh.points);
    CAPTURE(text);
    CHECK(text.find(words) != std::string::npos);
  };
  const FaceId f{3};
  says([&](FaceStructure& s) { std::swap(s.sides[f][0], s.sides[f][1]); },
       "are not the four of four vertices");
  says([&](FaceStructure& s) { s.corners[f][1] = VertexId{11}; }, "are not the four of four vertices");
  says([&](FaceStructure& s) { s.sides[f] = {}; }, "are not the four of four vertices");
  says([&](FaceStructure& s) { s.sides[f][0] = TetId{1000}; }, "tetrahedron 1000 is one of too many");
  says([&](FaceStructure& s) { s.sides[f][0] = s.sides[f][1] = TetId{20}; }, "the sides of tetrahedron");
}
