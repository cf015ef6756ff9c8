// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

/// Two meshes as one, the second moved and with vertices of its own.
TetMesh both(const TetMesh& first, const TetMesh& second, const Vec3& move, double scale = 1) {
  std::vector<Point3> points = first.points.flat();
  std::vector<tet_shelf::Corners> tets;
  for (const Point3& p : second.points) points.push_back(Point3{} + (scale * (p - Point3{}) + move));
  const auto add = [&](const TetMesh& mesh, std::size_t shift) {
    for (const auto& [a, b, c, d] : mesh.corners)
      tets.push_back({a.index() + shift, b.index() + shift, c.index() + shift, d.index() + shift});
  };
  add(first, 0);
  add(second, first.vertex_count());
  return tet_shelf::build(points, tets);
}

std::string words(const TetMesh& mesh) {
  REQUIRE_FALSE(mesh::validate(mesh));
  return mesh::validate_embedding(mesh).value_or("");
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("validate_embedding_finds_nothing_wrong_on_the_shelf_of_tetrahedra") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    CHECK(words(entry.mesh) == "");
  }
  CHECK_FALSE(mesh::validate_embedding(TetMesh{}));
}

TEST_CASE("parts_may_touch_back_to_back_in_faces_edges_and_vertices_of_their_own") {
  const TetMesh box = tet_shelf::box(2, 2, 2);
  CHECK(words(both(box, box, {2, 0, 0})) == "");
  CHECK(words(both(box, box, {2, 2, 0})) == "");
  CHECK(words(both(box, box, {2, 2, 2})) == "");
  CHECK(words(both(box, box, {1, -2, 2})) == "");
  CHECK(words(both(box, box, {3, 0, 0})) == "");
}

TEST_CASE("boundaries_that_cross_or_touch_elsewhere_are_named") {
  const TetMesh box = tet_shelf::box(2, 2, 2);
  for (const Vec3& move : {Vec3{0.5, 0.25, 0.125}, {1, 1, 0.5}, {2, 0.5, 0}, {1.5, 0, 0}, {2, 2, 0.5}}) {
    const std::string text = words(both(box, box, move));
    CAPTURE(text);
    CHECK(contains(text, "boundary face "));
    CHECK(contains(text, "cross or touch"));
  }
  // Where faces of both coincide, the tetrahedra are named.
  CHECK(contains(words(both(box, box, {1, 1, 1})), "overlap near vertex"));
  // A corner that rests on a face, by the last bit.
  const TetMesh tet = tet_shelf::build({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}}, {{0, 1, 2, 3}});
  CHECK(contains(words(both(box, tet, {0.75, 0.5, 2})), "cross or touch"));
  CHECK(words(both(box, tet, {0.75, 0.5, std::nextafter(2.0, 3.0)})) == "");
}

TEST_CASE("a_part_inside_another_is_named_and_one_inside_a_cavity_is_not") {
  const TetMesh box = tet_shelf::box(2, 2, 2), tet = tet_shelf::box(1, 1, 1);
  for (const Vec3& move : {Vec3{0.3, 0.2, 0.1}, {1.01, 1.02, 1.03}, {0.95, 0.95, 0.95}}) {
    const std::string text = words(both(box, tet, move, 0.01));
    CAPTURE(text);
    CHECK(contains(text, "tetrahedron"));
    CHECK(contains(text, "overlap near vertex"));
  }
  const TetMesh hollow = tet_shelf::cubes(tet_shelf::box_without(3, 3, 3, {{1, 1, 1}}));
  CHECK(words(both(hollow, tet, {1.25, 1.25, 1.25}, 0.5)) == "");
  CHECK(words(both(hollow, tet, {1, 1, 1})) == "");
  CHECK(contains(words(both(hollow, tet, {0.4, 0.4, 0.4}, 0.5)), "overlap near vertex"));
}

TEST_CASE("a_mesh_laid_over_itself_is_named") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    CHECK(contains(words(both(entry.mesh, entry.mesh, {})), "overlap near vertex"));
  }
}

TEST_CASE("tetrahedra_that_wind_twice_about_an_edge_are_named") {
  std::vector<Point3> points{{0, 0, -1}, {0, 0, 1}};
  std::vector<tet_shelf::Corners> tets;
  for (std::size_t i = 0; i < 7; ++i) {
    const double angle = 4 * std::acos(-1.0) * static_cast<double>(i) / 7;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    tets.push_back({0, 1, 2 + i, 2 + (i + 1) % 7});
  }
  CHECK(contains(words(tet_shelf::build(points, tets)), "cross or touch"));
}
