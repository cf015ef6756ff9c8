// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

struct Mutation {
  std::string name;
  std::function<void(TetMesh&)> apply;
  std::vector<std::string> words;
};

constexpr TetId first{0};

std::vector<Mutation> mutations() {
  return {
      {"regions too short", [](TetMesh& m) { m.regions.flat().pop_back(); }, {"regions has", "tetrahedra"}},
      {"neighbours too long",
       [](TetMesh& m) { m.neighbours.push_back({}); },
       {"neighbours has", "tetrahedra"}},
      {"no vertex markers", [](TetMesh& m) { m.vertex_markers.clear(); }, {"vertex_markers has 0"}},
      {"a coordinate infinite",
       [](TetMesh& m) { m.points[VertexId{1}].y = std::numeric_limits<double>::infinity(); },
       {"vertex 1 at", "inf", "no finite number"}},
      {"a corner out of range",
       [](TetMesh& m) { m.corners[first][2] = VertexId{123456}; },
       {"vertex 123456 of tetrahedron 0", "does not exist"}},
      {"a corner twice",
       [](TetMesh& m) { m.corners[first][3] = m.corners[first][0]; },
       {"tetrahedron 0", "twice"}},
      {"a tetrahedron turned over",
       [](TetMesh& m) { std::swap(m.corners[first][1], m.corners[first][2]); },
       {"tetrahedron 0", "turned over"}},
      {"a tetrahedron flattened",
       [](TetMesh& m) { m.points[m.corners[first][2]] = m.points[m.corners[first][0]]; },
       {"volume"}},
      {"a vertex unused",
       [](TetMesh& m) {
         m.points.push_back({50, 60, 70});
         m.vertex_markers.push_back(0);
       },
       {"at (50, 60, 70)", "no tetrahedron"}},
      {"a tetrahedron twice",
       [](TetMesh& m) {
         m.corners.push_back(m.corners[first]);
         m.neighbours.push_back({});
         m.regions.push_back(0);
       },
       {"same vertices as tetrahedron 0"}},
      {"neighbours in another order",
       [](TetMesh& m) {
         for (const TetId t : m.corners.ids()) {
           auto& n = m.neighbours[t];
           if (n[0] == n[1] && n[1] == n[2]) continue;
           n = {n[1], n[2], n[0], n[3]};
           return;
         }
         m.neighbours[first][1] = first;
       },
       {"as neighbour"}},
      {"a neighbour that is no tetrahedron",
       [](TetMesh& m) { m.neighbours[first][1] = TetId{99999}; },
       {"tetrahedron 0", "names tetrahedron 99999"}},
      {"a boundary face forgotten",
       [](TetMesh& m) { m.boundary.pop_back(); },
       {"boundary face", "no marker"}},
      {"a boundary face listed twice",
       [](TetMesh& m) { m.boundary.push_back(m.boundary.front()); },
       {"already as entry 0"}},
      {"a boundary face turned round",
       [](TetMesh& m) { std::swap(m.boundary[1].corners[0], m.boundary[1].corners[1]); },
       {"boundary entry 1", "points into the mesh"}},
      {"a boundary face of nowhere",
       [](TetMesh& m) {
         m.boundary[2] = {{VertexId{77777}, VertexId{1}, VertexId{0}}, 5};
       },
       {"boundary entry 2", "marker 5", "no boundary face"}},
      {"an interface on the boundary",
       [](TetMesh& m) { m.interfaces.push_back(m.boundary.front()); },
       {"interfaces entry 0", "between two tetrahedra"}},
      {"an interface of nowhere",
       [](TetMesh& m) {
         m.interfaces.push_back({{VertexId{0}, VertexId{88888}, VertexId{1}}, 5});
       },
       {"interfaces entry 0"}},
  };
}

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

TEST_CASE("validate_finds_nothing_wrong_on_the_shelf_of_tetrahedra") {
  for (const auto& entry : tet_shelf::all()) {
    const TetMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    CHECK(mesh::validate(mesh).value_or("") == "");
  }
  CHECK(mesh::validate(TetMesh{}).value_or("") == "");
}

TEST_CASE("validate_names_each_broken_invariant_on_every_mesh_of_the_shelf_of_tetrahedra") {
  for (const auto& entry : tet_shelf::all()) {
    for (const Mutation& mutation : mutations()) {
      TetMesh mesh = entry.mesh;
      mutation.apply(mesh);
      const std::string words = mesh::validate(mesh).value_or("");
      CAPTURE(entry.name);
      CAPTURE(mutation.name);
      CAPTURE(words);
      for (const std::string& word : mutation.words) CHECK(words.find(word) != std::string::npos);
    }
  }
}

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
