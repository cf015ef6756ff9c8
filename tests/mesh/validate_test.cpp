// SPDX-License-Identifier: MIT
#include "leonhard/mesh/validate.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <limits>

#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

/// One way to break a mesh, and what the validator's words must hold.
struct Mutation {
  std::string name;
  std::function<void(TriangleMesh&)> apply;
  std::vector<std::string> words;
};

const TriangleId first{0};

/// Every mesh of the shelf can be broken in these ways.
std::vector<Mutation> mutations() {
  return {
      {"neighbours too short",
       [](TriangleMesh& m) { m.neighbours.flat().pop_back(); },
       {"neighbours has", "triangles"}},
      {"regions too long", [](TriangleMesh& m) { m.regions.push_back(1); }, {"regions has", "triangles"}},
      {"vertex markers missing",
       [](TriangleMesh& m) { m.vertex_markers.clear(); },
       {"vertex_markers has 0 entries"}},
      {"a coordinate infinite",
       [](TriangleMesh& m) { m.points[VertexId{1}].x = std::numeric_limits<double>::infinity(); },
       {"vertex 1 at (inf", "no finite number"}},
      {"a corner out of range",
       [](TriangleMesh& m) { m.corners[first][2] = VertexId{123456}; },
       {"vertex 123456 of triangle 0", "does not exist"}},
      {"a corner twice",
       [](TriangleMesh& m) { m.corners[first][2] = m.corners[first][0]; },
       {"triangle 0", "twice"}},
      {"a triangle turned over",
       [](TriangleMesh& m) { std::swap(m.corners[first][1], m.corners[first][2]); },
       {"triangle 0", "clockwise"}},
      {"a triangle flattened",
       [](TriangleMesh& m) { m.points[m.corners[first][2]] = m.points[m.corners[first][0]]; },
       {"area"}},
      {"a vertex unused",
       [](TriangleMesh& m) {
         m.points.push_back({50, 60});
         m.vertex_markers.push_back(0);
       },
       {"at (50, 60)", "no triangle"}},
      {"a triangle twice",
       [](TriangleMesh& m) {
         m.corners.push_back(m.corners[first]);
         m.neighbours.push_back({});
         m.regions.push_back(0);
       },
       {"same vertices as triangle 0"}},
      {"a triangle rotated, but not its neighbours",
       [](TriangleMesh& m) {
         for (const TriangleId t : m.corners.ids()) {
           const auto& n = m.neighbours[t];
           if (n[0] == n[1] && n[1] == n[2]) continue;
           auto& c = m.corners[t];
           c = {c[1], c[2], c[0]};
           return;
         }
         m.neighbours[first][1] = first;  // the single triangle: make it its own neighbour
       },
       {"as neighbour"}},
      {"a neighbour that is no triangle",
       [](TriangleMesh& m) { m.neighbours[first][1] = TriangleId{99999}; },
       {"triangle 0", "names triangle 99999"}},
      {"a boundary edge forgotten",
       [](TriangleMesh& m) { m.boundary.pop_back(); },
       {"boundary edge", "no marker"}},
      {"a boundary edge listed twice",
       [](TriangleMesh& m) { m.boundary.push_back(m.boundary.front()); },
       {"already as entry 0"}},
      {"a boundary edge turned round",
       [](TriangleMesh& m) { std::swap(m.boundary[1].from, m.boundary[1].to); },
       {"boundary entry 1", "on its right"}},
      {"a boundary edge of nowhere",
       [](TriangleMesh& m) {
         m.boundary[2] = {VertexId{77777}, VertexId{1}, 5};
       },
       {"boundary entry 2", "marker 5", "no boundary edge"}},
      {"a constraint on the boundary",
       [](TriangleMesh& m) { m.constraints.push_back(m.boundary.front()); },
       {"constraints entry 0", "no interior edge"}},
      {"a constraint of nowhere",
       [](TriangleMesh& m) {
         m.constraints.push_back({VertexId{0}, VertexId{88888}, 5});
       },
       {"constraints entry 0"}},
  };
}

}  // namespace

TEST_CASE("validate_finds_nothing_wrong_on_the_shelf") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    CHECK(mesh::validate(mesh).value_or("") == "");
  }
}

TEST_CASE("validate_names_each_broken_invariant_on_every_mesh_of_the_shelf") {
  for (const auto& entry : shelf::all()) {
    for (const Mutation& mutation : mutations()) {
      TriangleMesh mesh = entry.mesh;
      mutation.apply(mesh);
      const std::string words = mesh::validate(mesh).value_or("");
      CAPTURE(entry.name);
      CAPTURE(mutation.name);
      CAPTURE(words);
      for (const std::string& word : mutation.words) CHECK(words.find(word) != std::string::npos);
    }
  }
}

TEST_CASE("validate_sees_a_link_missing_between_triangles_that_share_an_edge") {
  auto mesh = shelf::grid(2, 2);
  const TriangleId s{0}, t{1};
  for (auto& n : mesh.neighbours[s]) {
    if (n == MaybeId<TriangleId>(t)) n = {};
  }
  for (auto& n : mesh.neighbours[t]) {
    if (n == MaybeId<TriangleId>(s)) n = {};
  }
  const std::string words = mesh::validate(mesh).value_or("");
  CHECK(words.find("names none as neighbour") != std::string::npos);
  CHECK(words.find("there is triangle 1") != std::string::npos);
}

TEST_CASE("validate_takes_interior_constraints_in_either_direction") {
  auto mesh = shelf::grid(1, 1);
  mesh.constraints = {{VertexId{0}, VertexId{3}, 4}, {VertexId{3}, VertexId{0}, 4}};
  CHECK_FALSE(mesh::validate(mesh));
}

TEST_CASE("validate_delaunay_takes_cocircular_corners_and_names_the_edge_that_fails") {
  CHECK_FALSE(mesh::validate_delaunay(shelf::grid(4, 3)));
  const auto kite = [](double x) {  // Delaunay with the edge 0-2 if and only if |x| >= 1
    return shelf::build({{0, -1}, {x, 0}, {0, 1}, {-x, 0}}, {{0, 1, 2}, {0, 2, 3}});
  };
  CHECK_FALSE(mesh::validate_delaunay(kite(1)));
  CHECK_FALSE(mesh::validate_delaunay(kite(std::nextafter(1.0, 2.0))));
  const auto mesh = kite(std::nextafter(1.0, 0.0));
  const std::string words = mesh::validate_delaunay(mesh).value_or("");
  CHECK(words.find("edge") == 0);
  CHECK(words.find("from (0, 1) to (0, -1)") != std::string::npos);
  CHECK(words.find("triangle 1") != std::string::npos);
}

TEST_CASE("validate_delaunay_excepts_constraints") {
  auto mesh = shelf::build({{0, -1}, {0.5, 0}, {0, 1}, {-0.5, 0}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh::validate_delaunay(mesh));
  mesh.constraints = {{VertexId{2}, VertexId{0}, 1}};
  CHECK_FALSE(mesh::validate(mesh));
  CHECK_FALSE(mesh::validate_delaunay(mesh));
}
