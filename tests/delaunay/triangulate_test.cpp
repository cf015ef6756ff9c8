// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/triangulate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/exact_area.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::triangulate;
using delaunay::TriangulateOutcome;
using delaunay::Triangulation;

/// Twice the area of the convex hull, by Andrew's monotone chain in exact arithmetic.
mpq_class hull_area2(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Point2> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const Point2 p : points) {
      while (hull.size() >= start + 2 &&
             kernel::exact::orient2d(hull[hull.size() - 2], hull.back(), p) != Sign::positive)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return kernel::exact::area2(hull);
}

TEST_CASE("point_sets_of_every_degeneracy_give_valid_delaunay_meshes_that_fill_the_hull") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const Triangulation result = triangulate(family.points);
    REQUIRE(result.outcome == TriangulateOutcome::done);
    shapes::require_valid(result.mesh);
    CHECK(mesh::exact_area2(result.mesh) == hull_area2(family.points));
    for (std::size_t i = 0; i < family.points.size(); ++i) {
      REQUIRE(result.vertex_of_input[i].has_value());
      CHECK(result.mesh.points[*result.vertex_of_input[i]] == family.points[i]);
    }
  }
}

TEST_CASE("no_circumcircle_holds_a_vertex_by_brute_force_in_rational_arithmetic") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    if (family.points.size() > 100) continue;
    CAPTURE(family.name);
    const TriangleMesh mesh = triangulate(family.points).mesh;
    for (const auto& [a, b, c] : mesh.corners)
      for (const Point2 p : mesh.points)
        REQUIRE(kernel::exact::incircle(mesh.points[a], mesh.points[b], mesh.points[c], p) != Sign::positive);
  }
}

TEST_CASE("the_order_of_the_points_does_not_change_the_triangles") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const Fingerprint expected = mesh::fingerprint(triangulate(family.points).mesh);
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      CHECK(mesh::fingerprint(triangulate(shapes::shuffled(family.points, seed)).mesh) == expected);
  }
}

TEST_CASE("threads_change_no_bit_of_the_mesh") {
  // More points than one thread takes at a time.
  const std::vector<Point2> points = shapes::uniform(60'000);
  const TriangleMesh one = triangulate(points).mesh;
  for (const unsigned threads : {2U, 3U, 0U}) {
    delaunay::TriangulateOptions options;
    options.threads = threads;
    const TriangleMesh several = triangulate(points, options).mesh;
    CHECK(several.points == one.points);
    CHECK(several.corners == one.corners);
    CHECK(several.neighbours == one.neighbours);
    CHECK(several.boundary == one.boundary);
  }
}

TEST_CASE("the_hull_is_listed_counter_clockwise_from_its_lowest_vertex") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const std::vector<MarkedEdge> hull = triangulate(family.points).mesh.boundary;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      CHECK(hull[i].to == hull[(i + 1) % hull.size()].from);
      CHECK(hull[0].from <= hull[i].from);
      CHECK(hull[i].marker == 1);
    }
  }
}

TEST_CASE("moving_one_point_changes_the_fingerprint") {
  std::vector<Point2> points = shapes::uniform(50);
  const Fingerprint before = mesh::fingerprint(triangulate(points).mesh);
  points[7].x = std::nextafter(points[7].x, 2.0);
  CHECK(mesh::fingerprint(triangulate(points).mesh) != before);
}

TEST_CASE("vertices_are_numbered_as_the_points_and_duplicates_share_a_vertex") {
  const std::vector<Point2> points{{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}, {1, 1}};
  const Triangulation result = triangulate(points);
  const std::vector<std::size_t> expected{0, 1, 0, 2, 1, 3};
  for (std::size_t i = 0; i < points.size(); ++i) CHECK((*result.vertex_of_input[i]).index() == expected[i]);
  REQUIRE(result.repairs.size() == 1);
  CHECK(result.repairs[0].find("2 points merged") != std::string::npos);
  CHECK(result.repairs[0].find("point 2 with point 0") != std::string::npos);
}

TEST_CASE("points_that_span_no_triangle_are_an_outcome") {
  CHECK(triangulate(std::vector<Point2>{}).outcome == TriangulateOutcome::too_few_points);
  CHECK(triangulate(std::vector<Point2>{{1, 2}}).outcome == TriangulateOutcome::too_few_points);
  CHECK(triangulate(std::vector<Point2>{{1, 2}, {3, 4}, {1, 2}, {3, 4}}).outcome ==
        TriangulateOutcome::too_few_points);
  std::vector<Point2> line;
  for (int i = 0; i < 500; ++i) line.push_back({static_cast<double>(3 * i), static_cast<double>(-7 * i)});
  const Triangulation result = triangulate(line);
  CHECK(result.outcome == TriangulateOutcome::all_collinear);
  CHECK(result.mesh.triangle_count() == 0);
  line.push_back({1, -2});
  CHECK(triangulate(line).outcome == TriangulateOutcome::done);
}

TEST_CASE("nan_and_infinity_are_refused_by_name") {
  std::vector<Point2> points = shapes::uniform(10);
  points[4].y = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS((void)triangulate(points), doctest::Contains("point 4"), InputError);
  points[4].y = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS((void)triangulate(points), InputError);
}

TEST_CASE("a_hundred_thousand_points_are_valid") {
  const Triangulation result = triangulate(shapes::uniform(100'000));
  shapes::require_valid(result.mesh);
  CHECK(result.mesh.vertex_count() == 100'000);
  // Euler: T = 2 V - 2 - hull edges.
  CHECK(result.mesh.triangle_count() == 2 * 100'000 - 2 - result.mesh.boundary.size());
}

TEST_CASE("a_stop_request_ends_the_work_without_a_mesh") {
  std::stop_source source;
  delaunay::TriangulateOptions options;
  options.progress.stop = source.get_token();
  options.progress.report = [&](std::string_view, double fraction) {
    if (fraction > 0.3) source.request_stop();
  };
  const Triangulation result = triangulate(shapes::uniform(50'000), options);
  CHECK(result.outcome == TriangulateOutcome::stopped);
  CHECK(result.mesh.triangle_count() == 0);
}

}  // namespace
}  // namespace leonhard
