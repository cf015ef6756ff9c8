// SPDX-License-Identifier: MIT
#include "leonhard/mesh/topology.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/shelves.hpp"

using namespace leonhard;

namespace {

/// What make_triangle_mesh says to these arrays; empty if it takes them.
std::string refusal(std::vector<Point2> points, const std::vector<shelf::Corners>& triangles,
                    std::vector<MarkedEdge> boundary) {
  try {
    (void)mesh::make_triangle_mesh(PerId<VertexId, Point2>(std::move(points)), shelf::typed(triangles),
                                   std::move(boundary), {}, "box.su2");
  } catch (const InputError& error) {
    CHECK(error.where() == "box.su2");
    CHECK_FALSE(error.remedy().empty());
    return error.what();
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::vector<Point2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<shelf::Corners> halves{{0, 1, 2}, {0, 2, 3}};

template <std::size_t N>
std::size_t common_corners(const std::array<VertexId, N>& s, const std::array<VertexId, N>& t) {
  std::size_t count = 0;
  for (const VertexId v : s) count += static_cast<std::size_t>(std::count(t.begin(), t.end(), v));
  return count;
}

}  // namespace

TEST_CASE_TEMPLATE("neighbours_on_the_shelf_are_those_of_brute_force_across_the_facet_opposite_the_corner",
                   Mesh, TriangleMesh, TetMesh) {
  using Corners = typename Mesh::CellCorners;
  constexpr std::size_t corner_count = std::tuple_size_v<Corners>;
  for (const auto& entry : shelves::all<Mesh>()) {
    const Mesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const bool small = mesh.cell_count() < 700;
    std::size_t lone_sides = 0;
    for (const auto t : mesh.corners.ids()) {
      std::size_t found = 0;
      for (std::size_t i = 0; i < corner_count; ++i) {
        const auto n = mesh.neighbours[t][i];
        lone_sides += !n;
        if (!n) continue;
        ++found;
        const Corners& other = mesh.corners[*n];
        REQUIRE(common_corners(mesh.corners[t], other) == corner_count - 1);
        REQUIRE(std::count(other.begin(), other.end(), mesh.corners[t][i]) == 0);
        const auto& back = mesh.neighbours[*n];
        REQUIRE(std::count(back.begin(), back.end(), MaybeId(t)) == 1);
        const auto j =
            static_cast<std::size_t>(std::find(back.begin(), back.end(), MaybeId(t)) - back.begin());
        REQUIRE(std::count(mesh.corners[t].begin(), mesh.corners[t].end(), other[j]) == 0);
        if constexpr (shelves::is_plane<Mesh>) {
          CHECK(mesh.corners[t][(i + 1) % 3] == other[(j + 2) % 3]);
          CHECK(mesh.corners[t][(i + 2) % 3] == other[(j + 1) % 3]);
        }
      }
      if (!small) continue;
      std::size_t expected = 0;
      for (const Corners& other : mesh.corners)
        expected += common_corners(mesh.corners[t], other) == corner_count - 1;
      REQUIRE(found == expected);
    }
    CHECK(lone_sides == mesh.boundary.size());
  }
}

TEST_CASE("boundary_edges_given_backwards_are_turned_and_keep_order_and_marker") {
  const auto mesh =
      mesh::make_triangle_mesh(PerId<VertexId, Point2>(std::vector<Point2>(square)), shelf::typed(halves),
                               {{VertexId{3}, VertexId{2}, 7},
                                {VertexId{0}, VertexId{1}, 8},
                                {VertexId{0}, VertexId{3}, 9},
                                {VertexId{1}, VertexId{2}, 10}},
                               {{7, "lid"}});
  CHECK(mesh.boundary == std::vector<MarkedEdge>{{VertexId{2}, VertexId{3}, 7},
                                                 {VertexId{0}, VertexId{1}, 8},
                                                 {VertexId{3}, VertexId{0}, 9},
                                                 {VertexId{1}, VertexId{2}, 10}});
  CHECK(mesh.marker_names.at(7) == "lid");
  CHECK(mesh.vertex_markers.size() == 4);
  CHECK(mesh.regions.size() == 2);
  CHECK_FALSE(mesh::validate(mesh));
}

TEST_CASE("make_triangle_mesh_refuses_bad_input_and_names_it") {
  const auto good = shelf::lone_edges(halves, 1);
  CHECK(refusal(square, halves, good).empty());

  SUBCASE("a coordinate that is not a number") {
    auto points = square;
    points[2].y = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(refusal(points, halves, good), "vertex 2 at (1, nan)"));
  }
  SUBCASE("a corner out of range") {
    CHECK(contains(refusal(square, {{0, 1, 2}, {0, 2, 9}}, good), "vertex 9 of triangle 1"));
    CHECK(contains(refusal(square, {{0, 1, 2}, {0, 2, 9}}, good), "4 vertices"));
  }
  SUBCASE("a corner named twice") {
    CHECK(contains(refusal(square, {{0, 1, 2}, {0, 2, 2}}, good), "triangle 1 (vertices 0, 2, 2"));
  }
  SUBCASE("an area of zero, however thin the doubt") {
    CHECK(contains(refusal({{0, 0}, {1, 1}, {0.1, 0.1}, {0, 1}}, {{0, 1, 3}, {0, 2, 1}}, {}),
                   "triangle 1 (vertices 0, 2, 1"));
    CHECK(
        contains(refusal({{0, 0}, {1, 1}, {0.1, 0.1}, {0, 1}}, {{0, 1, 3}, {0, 2, 1}}, {}), "has area zero"));
  }
  SUBCASE("a triangle turned over") {
    CHECK(contains(refusal(square, {{0, 1, 2}, {0, 3, 2}}, good), "triangle 1"));
    CHECK(contains(refusal(square, {{0, 1, 2}, {0, 3, 2}}, good), "clockwise"));
  }
  SUBCASE("a vertex of no triangle") {
    auto points = square;
    points.push_back({5, 6});
    CHECK(contains(refusal(points, halves, good), "vertex 4 at (5, 6) belongs to no triangle"));
  }
  SUBCASE("an edge of three triangles") {
    auto points = square;
    points.push_back({0.25, 2});
    const auto text = refusal(points, {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}, {});
    CHECK(contains(text, "edge 0-2"));
    CHECK(contains(text, "3 triangles"));
  }
  SUBCASE("two triangles on one side of an edge") {
    CHECK(contains(refusal({{0, 0}, {1, 0}, {0, 1}, {0.5, 2}}, {{0, 1, 2}, {0, 1, 3}}, {}),
                   "triangles 0 and 1 lie on the same side of edge 0-1"));
  }
  SUBCASE("a triangle given twice") {
    CHECK(contains(refusal(square, {{0, 1, 2}, {0, 2, 3}, {1, 2, 0}}, good), "triangle 2"));
    CHECK(contains(refusal(square, {{0, 1, 2}, {0, 2, 3}, {1, 2, 0}}, good), "same vertices as triangle 0"));
  }
  SUBCASE("a boundary edge without marker: a cell is missing") {
    CHECK(contains(refusal({{0, 0}, {1, 0}, {1, 1}}, {{0, 1, 2}}, {good[0], good[1]}),
                   "edge 2-0 from (1, 1) to (0, 0)"));
  }
  SUBCASE("a boundary edge marked twice") {
    auto boundary = good;
    boundary.push_back({boundary[1].to, boundary[1].from, 3});
    CHECK(contains(refusal(square, halves, boundary), "there already as entry 1"));
  }
  SUBCASE("an interior edge marked as boundary") {
    auto boundary = good;
    boundary.push_back({VertexId{0}, VertexId{2}, 3});
    CHECK(contains(refusal(square, halves, boundary), "boundary entry 4, edge 0-2"));
  }
  SUBCASE("a marked edge of vertices that do not exist") {
    auto boundary = good;
    boundary.push_back({VertexId{0}, VertexId{77}, 3});
    CHECK(contains(refusal(square, halves, boundary), "edge 0-77"));
  }
}

TEST_CASE_TEMPLATE("build_neighbours_leaves_the_mesh_alone_when_it_refuses", Mesh, TriangleMesh, TetMesh) {
  auto mesh = shelves::regular<Mesh>(2);
  const auto before = mesh.neighbours;
  auto& corners = mesh.corners.flat()[3];
  std::swap(corners[0], corners[1]);
  CHECK_THROWS_AS(mesh::build_neighbours(mesh), InputError);
  CHECK(mesh.neighbours == before);
  std::swap(corners[0], corners[1]);
  mesh.neighbours.clear();
  mesh::build_neighbours(mesh);
  CHECK(mesh.neighbours == before);
}
