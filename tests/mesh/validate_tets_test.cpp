// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

/// Do all other vertices lie outside the open circumspheres of all tetrahedra, by GMP?
bool is_delaunay_by_brute_force(const TetMesh& mesh) {
  for (const auto& [a, b, c, d] : mesh.corners) {
    for (const Point3& e : mesh.points) {
      if (kernel::exact::insphere(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d], e) ==
          Sign::positive)
        return false;
    }
  }
  return true;
}

/// Two ways to fill the hull of two points above and below a triangle.
TetMesh two_or_three(bool three, double height) {
  const std::vector<Point3> points{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, height}, {0, 0, -height}};
  if (three) return tet_shelf::build(points, {{4, 3, 0, 1}, {4, 3, 1, 2}, {4, 3, 2, 0}});
  return tet_shelf::build(points, {{0, 1, 2, 3}, {0, 2, 1, 4}});
}

std::string convex_words(const TetMesh& mesh) { return mesh::validate_convex(mesh).value_or(""); }

}  // namespace

TEST_CASE("validate_takes_interfaces_between_tetrahedra_in_either_direction") {
  auto mesh = two_or_three(false, 1);
  mesh.interfaces = {{{VertexId{0}, VertexId{1}, VertexId{2}}, 4},
                     {{VertexId{2}, VertexId{1}, VertexId{0}}, 4}};
  CHECK_FALSE(mesh::validate(mesh));
}

TEST_CASE("validate_delaunay_of_tetrahedra_says_what_brute_force_says") {
  CHECK_FALSE(mesh::validate_delaunay(tet_shelf::box(2, 3, 2)));  // cospherical corners everywhere
  int delaunay = 0;
  for (const double height : {0.25, 0.5, 0.9, 1.0, 1.1, 1.5, 3.0}) {
    for (const bool three : {false, true}) {
      CAPTURE(height);
      CAPTURE(three);
      const auto mesh = two_or_three(three, height);
      const bool expected = is_delaunay_by_brute_force(mesh);
      delaunay += expected;
      CHECK(mesh::validate_delaunay(mesh).has_value() != expected);
    }
  }
  CHECK(delaunay >= 7);
  CHECK(delaunay < 14);
  const auto shaken = tet_shelf::shaken_box(3, 5);
  CHECK(mesh::validate_delaunay(shaken).has_value() != is_delaunay_by_brute_force(shaken));
}

TEST_CASE("validate_delaunay_decides_by_the_last_bit_names_the_face_and_excepts_interfaces") {
  // 0, 1, 2 and 3 lie on the unit sphere about the origin.
  const auto mesh_with = [](double z) {
    return tet_shelf::build({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, z}},
                            {{0, 1, 2, 3}, {0, 2, 1, 4}});
  };
  CHECK_FALSE(mesh::validate_delaunay(mesh_with(-1)));
  CHECK_FALSE(mesh::validate_delaunay(mesh_with(std::nextafter(-1.0, -2.0))));
  auto mesh = mesh_with(std::nextafter(-1.0, 0.0));
  const std::string words = mesh::validate_delaunay(mesh).value_or("");
  CAPTURE(words);
  CHECK(words.find("face 0-2-1 at (1, 0, 0), (-1, 0, 0), (0, 1, 0) is not locally Delaunay: vertex 4") == 0);
  CHECK(words.find("corner of tetrahedron 1, lies inside the circumsphere of tetrahedron 0") !=
        std::string::npos);
  mesh.interfaces = {{{VertexId{2}, VertexId{0}, VertexId{1}}, 1}};
  CHECK_FALSE(mesh::validate_delaunay(mesh));
}

TEST_CASE("validate_convex_takes_boxes_and_hulls_and_refuses_all_others_on_the_shelf") {
  for (const auto& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const bool convex = entry.name == "single tetrahedron" || entry.name == "two tetrahedra" ||
                        entry.name == "octahedron of four about an inner edge" ||
                        entry.name == "cube of five" || entry.name == "cube of six" || entry.name == "box";
    CHECK(mesh::validate_convex(entry.mesh).has_value() != convex);
  }
  CHECK_FALSE(mesh::validate_convex(TetMesh{}));
}

TEST_CASE("validate_convex_names_the_edge_that_is_reflex_by_the_last_bit") {
  const auto roof = [](double z) {  // two tetrahedra side by side; the ridge 0-1 is flat at z = 0
    return tet_shelf::build({{0, 0, z}, {0, 1, z}, {-1, 0.5, 0}, {1, 0.5, 0}, {0, 0.5, -1}},
                            {{0, 2, 1, 4}, {1, 3, 0, 4}});
  };
  CHECK(convex_words(roof(0)) == "");
  CHECK(convex_words(roof(0x1p-1060)) == "");
  const std::string words = convex_words(roof(-0x1p-1060));
  CAPTURE(words);
  CHECK(words.find("the boundary is not convex: at edge 0-1 from (0, 0, -") == 0);
}

TEST_CASE("validate_convex_sees_a_second_layer_over_the_first") {
  // Positive tetrahedra about an inner edge that turn round it twice: seven of 720/7 degrees.
  std::vector<Point3> points{{0, 0, -1}, {0, 0, 1}};
  std::vector<tet_shelf::Corners> tets;
  for (std::size_t i = 0; i < 7; ++i) {
    const double angle = 4 * std::acos(-1.0) * static_cast<double>(i) / 7;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    tets.push_back({0, 1, 2 + i, 2 + (i + 1) % 7});
  }
  const auto mesh = tet_shelf::build(points, tets);
  CHECK_FALSE(mesh::validate(mesh));
  CHECK(convex_words(mesh).find("overlap at") != std::string::npos);
}
