// SPDX-License-Identifier: MIT
#include "leonhard/mesh/validate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/mesh/shelves.hpp"

using namespace leonhard;

namespace {

/// One way to break a mesh, and what the validator's words must hold.
template <class Mesh>
struct Mutation {
  std::string name;
  std::function<void(Mesh&)> apply;
  std::vector<std::string> words;
};

void turn_first_corners(MarkedEdge& edge) { std::swap(edge.from, edge.to); }
void turn_first_corners(MarkedFace& face) { std::swap(face.corners[0], face.corners[1]); }

/// Every mesh of the shelves can be broken in these ways.
template <class Mesh>
std::vector<Mutation<Mesh>> mutations() {
  constexpr bool plane = shelves::is_plane<Mesh>;
  using Kind = shelves::Kind<Mesh>;
  using CellId = typename Mesh::CellId;
  static constexpr CellId first{0};
  const std::string cell = Kind::cell, cells = Kind::cells, facet = Kind::facet, cell_0 = cell + " 0",
                    inner = plane ? "constraints" : "interfaces";
  const auto facet_of = [](IdRaw a, IdRaw b, Marker marker) {
    typename Mesh::FacetCorners corners{};
    corners[0] = VertexId{a};
    corners[1] = VertexId{b};
    return Kind::marked(corners, marker);
  };
  return {
      {"neighbours too short", [](Mesh& m) { m.neighbours.flat().pop_back(); }, {"neighbours has", cells}},
      {"neighbours too long", [](Mesh& m) { m.neighbours.push_back({}); }, {"neighbours has", cells}},
      {"regions too short", [](Mesh& m) { m.regions.flat().pop_back(); }, {"regions has", cells}},
      {"regions too long", [](Mesh& m) { m.regions.push_back(1); }, {"regions has", cells}},
      {"vertex markers missing", [](Mesh& m) { m.vertex_markers.clear(); }, {"vertex_markers has 0 entries"}},
      {"a coordinate infinite",
       [](Mesh& m) { m.points[VertexId{1}].y = std::numeric_limits<double>::infinity(); },
       {"vertex 1 at (", "inf", "no finite number"}},
      {"a corner out of range",
       [](Mesh& m) { m.corners[first][2] = VertexId{123456}; },
       {"vertex 123456 of " + cell_0, "does not exist"}},
      {"a corner twice", [](Mesh& m) { m.corners[first].back() = m.corners[first][0]; }, {cell_0, "twice"}},
      {"a cell turned over",
       [](Mesh& m) { std::swap(m.corners[first][1], m.corners[first][2]); },
       {cell_0, plane ? "clockwise" : "turned over"}},
      {"a cell flattened",
       [](Mesh& m) { m.points[m.corners[first][2]] = m.points[m.corners[first][0]]; },
       {plane ? "area" : "volume"}},
      {"a vertex unused",
       [](Mesh& m) {
         typename Mesh::Point far{};
         far.x = 50;
         far.y = 60;
         m.points.push_back(far);
         m.vertex_markers.push_back(0);
       },
       {"at (50, 60", "no " + cell}},
      {"a cell twice",
       [](Mesh& m) {
         m.corners.push_back(m.corners[first]);
         m.neighbours.push_back({});
         m.regions.push_back(0);
       },
       {"same vertices as " + cell_0}},
      {"neighbours in another order",
       [](Mesh& m) {
         for (auto& n : m.neighbours) {
           if (n[0] == n[1] && n[1] == n[2]) continue;
           std::rotate(n.begin(), n.begin() + 1, n.begin() + 3);
           return;
         }
         m.neighbours[first][1] = first;  // the single cell: make it its own neighbour
       },
       {"as neighbour"}},
      {"a neighbour that is no cell",
       [](Mesh& m) { m.neighbours[first][1] = CellId{99999}; },
       {cell_0, "names " + cell + " 99999"}},
      {"a boundary facet forgotten",
       [](Mesh& m) { m.boundary.pop_back(); },
       {"boundary " + facet, "no marker"}},
      {"a boundary facet listed twice",
       [](Mesh& m) { m.boundary.push_back(m.boundary.front()); },
       {"already as entry 0"}},
      {"a boundary facet turned round",
       [](Mesh& m) { turn_first_corners(m.boundary[1]); },
       {"boundary entry 1", plane ? "on its right" : "points into the mesh"}},
      {"a boundary facet of nowhere",
       [=](Mesh& m) { m.boundary[2] = facet_of(77777, 1, 5); },
       {"boundary entry 2", "marker 5", "no boundary " + facet}},
      {"an inner facet on the boundary",
       [](Mesh& m) { m.inner_facets().push_back(m.boundary.front()); },
       {inner + " entry 0", plane ? "no interior edge" : "between two tetrahedra"}},
      {"an inner facet of nowhere",
       [=](Mesh& m) { m.inner_facets().push_back(facet_of(0, 88888, 5)); },
       {inner + " entry 0"}},
  };
}

}  // namespace

TEST_CASE_TEMPLATE("validate_finds_nothing_wrong_on_the_shelf", Mesh, TriangleMesh, TetMesh) {
  for (const auto& entry : shelves::all<Mesh>()) {
    CAPTURE(entry.name);
    CHECK(mesh::validate(entry.mesh).value_or("") == "");
  }
  CHECK(mesh::validate(Mesh{}).value_or("") == "");
}

TEST_CASE_TEMPLATE("validate_names_each_broken_invariant_on_every_mesh_of_the_shelf", Mesh, TriangleMesh,
                   TetMesh) {
  for (const auto& entry : shelves::all<Mesh>()) {
    for (const auto& mutation : mutations<Mesh>()) {
      Mesh mesh = entry.mesh;
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
