// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/divide_and_conquer.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>

#include "leonhard/delaunay/plane/watson.hpp"
#include "leonhard/delaunay/topology/from_quad_edge.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/mesh/data_structures.hpp"
#include "tests/delaunay/shapes.hpp"
#include "tests/mesh/shelf.hpp"

namespace leonhard {
namespace {

using delaunay::GhostTriangulation;
using delaunay::PointTriangulation;
using Triangles = std::set<std::array<IdRaw, 3>>;

std::array<IdRaw, 3> sorted(std::array<IdRaw, 3> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

Triangles real_triangles(const GhostTriangulation& in) {
  Triangles all;
  for (std::size_t i = 0; i < in.triangle_count(); ++i) {
    const delaunay::AnyTriangleId t = delaunay::AnyTriangleId::from(i);
    if (!in.is_ghost(t)) all.insert(sorted({in.corner(t, 0).raw, in.corner(t, 1).raw, in.corner(t, 2).raw}));
  }
  return all;
}

TEST_CASE("halves_of_every_size_up_to_forty_merge_to_the_triangles_of_watson") {
  for (std::size_t n = 3; n <= 40; ++n) {
    CAPTURE(n);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      // Points of a coarse grid: collinear halves, cocircular quadruples, equal abscissas.
      std::vector<Point2> points;
      for (const Point2 p : shapes::uniform(n, seed))
        points.push_back({std::floor(9 * p.x), std::floor(9 * p.y)});
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(), points.end()), points.end());
      const PointTriangulation expected = delaunay::triangulate_watson(points);
      const PointTriangulation result = delaunay::triangulate_divide_and_conquer(points);
      REQUIRE(result.outcome == expected.outcome);
      REQUIRE_FALSE(result.triangulation.validate());
      REQUIRE(real_triangles(result.triangulation) == real_triangles(expected.triangulation));
    }
  }
}

TEST_CASE("thousands_of_points_on_two_vertical_lines_and_on_a_circle_merge") {
  std::vector<Point2> lines, circle;
  for (int i = 0; i < 3000; ++i) {
    lines.push_back({i % 2 == 0 ? 0.0 : 1.0, i / 7.0});
    circle.push_back({std::cos(0.002 * i), std::sin(0.002 * i)});
  }
  for (const std::vector<Point2>& points : {lines, circle}) {
    const PointTriangulation result = delaunay::triangulate_divide_and_conquer(points);
    CHECK(result.triangulation.triangle_count() == 2 * points.size() - 2);
    CHECK(real_triangles(result.triangulation) ==
          real_triangles(delaunay::triangulate_watson(points).triangulation));
  }
}

TEST_CASE("a_quad_edge_structure_becomes_triangles_with_ghosts_round_every_boundary") {
  for (const shelf::Entry& entry : shelf::all()) {
    CAPTURE(entry.name);
    const GhostTriangulation in = delaunay::ghost_triangulation(mesh::quad_edge(entry.mesh));
    CHECK_FALSE(in.validate());
    REQUIRE(in.triangle_count() == entry.mesh.triangle_count() + entry.mesh.boundary.size());
    for (const TriangleId t : entry.mesh.corners.ids()) {
      const auto& [a, b, c] = entry.mesh.corners[t];
      CHECK(sorted({in.corner(t, 0).raw, in.corner(t, 1).raw, in.corner(t, 2).raw}) ==
            sorted({a.raw, b.raw, c.raw}));
    }
  }
}

}  // namespace
}  // namespace leonhard
