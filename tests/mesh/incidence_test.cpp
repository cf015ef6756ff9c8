// SPDX-License-Identifier: MIT
#include "leonhard/mesh/incidence.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/shelf.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;

namespace {

template <class Mesh, class Span>
void check_row(const Mesh& mesh, VertexId v, const Span& row) {
  auto sorted = std::vector(row.begin(), row.end());
  std::sort(sorted.begin(), sorted.end());
  decltype(sorted) expected;
  for (const auto c : mesh.corners.ids()) {
    if (std::count(mesh.corners[c].begin(), mesh.corners[c].end(), v) > 0) expected.push_back(c);
  }
  CHECK(sorted == expected);
}

/// The corner of t that follows v, `steps` further counter-clockwise.
VertexId after(const TriangleMesh& mesh, TriangleId t, VertexId v, std::size_t steps) {
  const auto& c = mesh.corners[t];
  const auto at = static_cast<std::size_t>(std::find(c.begin(), c.end(), v) - c.begin());
  return c[(at + steps) % 3];
}

bool on_boundary(const TriangleMesh& mesh, VertexId from, VertexId to) {
  return std::any_of(mesh.boundary.begin(), mesh.boundary.end(),
                     [&](const MarkedEdge& e) { return e.from == from && e.to == to; });
}

/// A row is a closed fan that starts at its smallest triangle, or fans from one boundary edge to another, sorted by first
/// triangles.
void check_fans(const TriangleMesh& mesh, VertexId v, std::span<const TriangleId> row) {
  REQUIRE(!row.empty());
  const bool closed = !on_boundary(mesh, v, after(mesh, row[0], v, 1));
  if (closed) {
    CHECK(*std::min_element(row.begin(), row.end()) == row[0]);
    CHECK(after(mesh, row.back(), v, 2) == after(mesh, row[0], v, 1));
  } else {
    CHECK(on_boundary(mesh, after(mesh, row.back(), v, 2), v));
  }
  TriangleId start = row[0];
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (after(mesh, row[i - 1], v, 2) == after(mesh, row[i], v, 1)) continue;
    CHECK(on_boundary(mesh, after(mesh, row[i - 1], v, 2), v));
    CHECK(on_boundary(mesh, v, after(mesh, row[i], v, 1)));
    CHECK(start < row[i]);
    start = row[i];
  }
}

}  // namespace

TEST_CASE("triangles_at_a_vertex_are_those_that_name_it_in_counter_clockwise_fans") {
  for (const auto& [label, mesh, components, holes, pinches] : shelf::all()) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const mesh::TriangleIncidence incidence(mesh);
    CHECK(incidence.vertex_count() == mesh.vertex_count());
    for (const VertexId v : mesh.points.ids()) {
      check_row(mesh, v, incidence.triangles_at(v));
      check_fans(mesh, v, incidence.triangles_at(v));
    }
  }
}

TEST_CASE("a_fan_starts_at_the_boundary_whatever_the_order_of_triangles") {
  const TriangleMesh fan = shelf::build({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1}},
                                        {{0, 3, 4}, {2, 3, 0}, {5, 0, 4}, {1, 2, 0}});
  const mesh::TriangleIncidence incidence(fan);
  const auto row = incidence.triangles_at(VertexId{0});
  CHECK(std::vector(row.begin(), row.end()) ==
        std::vector{TriangleId{3}, TriangleId{1}, TriangleId{0}, TriangleId{2}});
}

TEST_CASE("two_closed_fans_over_each_other_are_listed_one_after_the_other") {
  // Two wheels of three triangles about one hub: no mesh that lies properly in the plane, but each edge is in order.
  const std::vector<Point2> points{{0, 0}, {2, 0}, {-1, 2}, {-1, -2}, {3, 0}, {-2, 3}, {-2, -3}};
  const TriangleMesh wheels =
      shelf::build(points, {{0, 1, 2}, {0, 4, 5}, {0, 5, 6}, {0, 2, 3}, {0, 3, 1}, {0, 6, 4}});
  REQUIRE(!mesh::validate(wheels));
  const mesh::TriangleIncidence incidence(wheels);
  const auto row = incidence.triangles_at(VertexId{0});
  CHECK(std::vector(row.begin(), row.end()) == std::vector{TriangleId{0}, TriangleId{3}, TriangleId{4},
                                                           TriangleId{1}, TriangleId{2}, TriangleId{5}});
}

TEST_CASE("tetrahedra_at_a_vertex_are_those_that_name_it_in_ascending_order") {
  for (const tet_shelf::Entry& entry : tet_shelf::all()) {
    CAPTURE(entry.name);
    const mesh::TetIncidence incidence(entry.mesh);
    for (const VertexId v : entry.mesh.points.ids()) {
      const auto row = incidence.tets_at(v);
      CHECK(std::is_sorted(row.begin(), row.end()));
      check_row(entry.mesh, v, row);
    }
  }
}

TEST_CASE("incidence_refuses_vertices_and_corners_that_do_not_exist") {
  TriangleMesh grid = shelf::grid(2, 2);
  const mesh::TriangleIncidence incidence(grid);
  CHECK_THROWS_WITH_AS((void)incidence.triangles_at(VertexId{9}), doctest::Contains("vertex 9"), InputError);
  grid.corners[TriangleId{3}][1] = VertexId{77};
  CHECK_THROWS_WITH_AS(mesh::TriangleIncidence{grid}, doctest::Contains("77"), InputError);
  TetMesh box = tet_shelf::box(1, 1, 1);
  const mesh::TetIncidence tet_incidence(box);
  CHECK_THROWS_AS((void)tet_incidence.tets_at(VertexId{8}), InputError);
  box.corners[TetId{0}][0] = VertexId{8};
  CHECK_THROWS_AS(mesh::TetIncidence{box}, InputError);
  TriangleMesh torn = shelf::grid(2, 2);
  for (const TriangleId t : torn.neighbours.ids())
    torn.neighbours[t] = {TriangleId{0}, TriangleId{0}, TriangleId{0}};
  CHECK_THROWS_AS(mesh::TriangleIncidence{torn}, InputError);
}
