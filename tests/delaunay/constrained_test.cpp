// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>

#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/exact_area.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::triangulate;
using delaunay::Triangulation;
using kernel::orient2d;

using EdgeSet = std::set<std::pair<Point2, Point2>>;

std::pair<Point2, Point2> sorted(Point2 a, Point2 b) { return {std::min(a, b), std::max(a, b)}; }

EdgeSet marked_edges(const TriangleMesh& mesh) {
  EdgeSet edges;
  for (const auto* list : {&mesh.boundary, &mesh.constraints})
    for (const MarkedEdge& e : *list) edges.insert(sorted(mesh.points[e.from], mesh.points[e.to]));
  return edges;
}

/// The pieces into which the mesh's vertices cut the graph's segments.
EdgeSet expected_pieces(const Pslg& pslg, const TriangleMesh& mesh) {
  EdgeSet edges;
  for (const Pslg::Segment& s : pslg.segments) {
    const auto [a, b] = sorted(pslg.points[s.from], pslg.points[s.to]);
    std::vector<Point2> on{a, b};
    for (const Point2 p : mesh.points)
      if (a < p && p < b && kernel::exact::orient2d(a, b, p) == Sign::zero) on.push_back(p);
    std::sort(on.begin(), on.end());
    for (std::size_t i = 1; i < on.size(); ++i)
      if (on[i - 1] != on[i]) edges.insert({on[i - 1], on[i]});
  }
  return edges;
}

TEST_CASE("segments_become_edges_cut_at_every_vertex_on_them_and_nothing_else_is_marked") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const Pslg pslg = shapes::random_graph(seed);
    const Triangulation result = triangulate(pslg);
    shapes::require_valid(result.mesh);
    CHECK(marked_edges(result.mesh) == expected_pieces(pslg, result.mesh));
  }
}

TEST_CASE("no_vertex_in_a_circumcircle_is_visible_from_its_triangle_by_brute_force") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    const Pslg pslg = shapes::random_graph(seed);
    const TriangleMesh mesh = triangulate(pslg).mesh;
    for (const auto& [i, j, k] : mesh.corners) {
      const Point2 a = mesh.points[i], b = mesh.points[j], c = mesh.points[k];
      const Point2 centroid{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
      for (const Point2 p : mesh.points) {
        if (kernel::exact::incircle(a, b, c, p) != Sign::positive) continue;
        const bool hidden =
            std::any_of(pslg.segments.begin(), pslg.segments.end(), [&](const Pslg::Segment& s) {
              const Point2 u = pslg.points[s.from], v = pslg.points[s.to];
              return orient2d(centroid, p, u) != orient2d(centroid, p, v) &&
                     orient2d(u, v, centroid) * orient2d(u, v, p) == Sign::negative;
            });
        CHECK(hidden);
      }
    }
  }
}

TEST_CASE("the_order_of_points_and_segments_does_not_change_the_triangles") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const Pslg pslg = shapes::random_graph(seed);
    const Fingerprint expected = mesh::fingerprint(triangulate(pslg).mesh);
    for (std::uint64_t shuffle = 1; shuffle <= 3; ++shuffle)
      CHECK(mesh::fingerprint(triangulate(shapes::shuffled(pslg, shuffle)).mesh) == expected);
  }
}

TEST_CASE("carving_leaves_exactly_the_area_between_outline_and_holes") {
  Pslg pslg = shapes::nested();
  CHECK(mesh::exact_area2(triangulate(pslg).mesh) == 2 * 64 * 64);
  pslg.holes = {{25, 25}};  // the island's ring; the lake in it stays
  const TriangleMesh mesh = triangulate(pslg).mesh;
  shapes::require_valid(mesh);
  CHECK(mesh::exact_area2(mesh) == 2 * (64 * 64 - 16 * 16 + 4 * 4));
  pslg.holes.push_back({32, 32});
  CHECK(mesh::exact_area2(triangulate(pslg).mesh) == 2 * (64 * 64 - 16 * 16));
  CHECK(mesh::exact_area2(triangulate(shapes::comb(20, 50)).mesh) == 2 * (40 + 20 * 50));
}

TEST_CASE("concavities_stay_where_the_convex_hull_is_kept") {
  const Pslg pslg = shapes::comb(5, 10);
  const Triangulation hull = triangulate(pslg, {.keep_convex_hull = true, .progress = {}});
  shapes::require_valid(hull.mesh);
  const std::vector<Point2> outline{{0, -1}, {10, -1}, {10, 0}, {9, 10}, {0, 10}};
  CHECK(mesh::exact_area2(hull.mesh) == kernel::exact::area2(outline));
}

TEST_CASE("boundary_edges_carry_their_segments_marker_and_0_where_there_is_none") {
  Pslg pslg;
  shapes::add_loop(pslg, shapes::box(0, 0, 4, 4), 0);
  pslg.segments[1].marker = 9;
  pslg.points.push_back({2, 2});
  pslg.segments.push_back({0, 4, 6});
  pslg.point_markers = {0, 3, 0, 0, 8};
  pslg.marker_names = {{9, "right"}};
  const TriangleMesh mesh = triangulate(pslg).mesh;
  std::multiset<Marker> markers;
  for (const MarkedEdge& e : mesh.boundary) markers.insert(e.marker);
  CHECK(markers == std::multiset<Marker>{0, 0, 0, 9});
  REQUIRE(mesh.constraints.size() == 1);
  CHECK(mesh.constraints[0].marker == 6);
  CHECK(mesh.vertex_markers.flat() == std::vector<Marker>{0, 3, 0, 0, 8});
  CHECK(mesh.marker_names.at(9) == "right");
}

TEST_CASE("regions_are_filled_up_to_segments") {
  Pslg pslg = shapes::nested();
  pslg.regions = {{{1, 1}, 10, -1}, {{32, 32}, 30, -1}, {{2, 2}, 11, -1}};
  const Triangulation result = triangulate(pslg);
  std::map<double, mpq_class> area2;
  for (const TriangleId t : result.mesh.corners.ids()) {
    const auto [a, b, c] = result.mesh.corners[t];
    const std::vector<Point2> corners{result.mesh.points[a], result.mesh.points[b], result.mesh.points[c]};
    area2[result.mesh.regions[t]] += kernel::exact::area2(corners);
  }
  CHECK(area2.size() == 3);
  CHECK(area2[10] == 2 * (64 * 64 - 16 * 16));
  CHECK(area2[0] == 2 * (16 * 16 - 4 * 4));
  CHECK(area2[30] == 2 * 4 * 4);
  REQUIRE(result.repairs.size() == 1);
  CHECK(result.repairs[0].find("region 2") != std::string::npos);
}

TEST_CASE("crossing_segments_are_refused_with_both_names_and_coordinates") {
  Pslg pslg;
  shapes::add_loop(pslg, shapes::box(0, 0, 4, 4));
  shapes::add_loop(pslg, shapes::box(3, 1, 4, 2));
  pslg.source = "bodies";
  try {
    (void)triangulate(pslg);
    FAIL("crossing bodies were accepted");
  } catch (const InputError& error) {
    CHECK(error.where() == "bodies");
    CHECK(error.problem().find("segment 1 (point 1 at (4, 0) to point 2 at (4, 4))") != std::string::npos);
    CHECK(error.problem().find("cross") != std::string::npos);
  }
}

TEST_CASE("overlapping_segments_are_merged_and_noted_and_the_earlier_marker_stays") {
  Pslg pslg;
  shapes::add_loop(pslg, shapes::box(0, 0, 4, 4), 2);
  pslg.points.push_back({1, 0});
  pslg.points.push_back({3, 0});
  pslg.segments.push_back({4, 5, 3});
  pslg.segments.push_back({1, 0, 5});
  const Triangulation result = triangulate(pslg);
  CHECK(result.repairs ==
        std::vector<std::string>{"segment 4 overlaps segment 0: merged where they do (counted from 0)",
                                 "segment 5 overlaps segment 0: merged where they do (counted from 0)"});
  CHECK(result.mesh.boundary.size() == 6);
  for (const MarkedEdge& e : result.mesh.boundary) CHECK(e.marker == 2);
}

TEST_CASE("seeds_on_segments_are_refused_and_seeds_outside_are_noted") {
  Pslg pslg = shapes::nested();
  pslg.holes = {{24, 30}};
  CHECK_THROWS_WITH_AS((void)triangulate(pslg),
                       doctest::Contains("hole 0 at (24, 30) lies exactly on a segment"), InputError);
  pslg.holes = {{64, 64}};
  CHECK_THROWS_AS((void)triangulate(pslg), InputError);
  pslg.holes = {{100, 3}};
  pslg.regions = {{{-1, -1}, 3, -1}};
  const Triangulation result = triangulate(pslg);
  CHECK(result.repairs.size() == 2);
  CHECK(mesh::exact_area2(result.mesh) == 2 * 64 * 64);
}

TEST_CASE("segments_that_enclose_nothing_are_refused") {
  Pslg pslg;
  pslg.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  pslg.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}};
  CHECK_THROWS_WITH_AS((void)triangulate(pslg), doctest::Contains("enclose nothing"), InputError);
  CHECK(triangulate(pslg, {.keep_convex_hull = true, .progress = {}}).mesh.triangle_count() == 2);
}

TEST_CASE("impossible_segments_are_refused") {
  Pslg pslg;
  shapes::add_loop(pslg, shapes::box(0, 0, 4, 4));
  pslg.segments.push_back({0, 4, 0});
  CHECK_THROWS_WITH_AS((void)triangulate(pslg), doctest::Contains("segment 4 ends in point 4"), InputError);
}

TEST_CASE("points_in_holes_are_left_out_and_noted") {
  Pslg pslg = shapes::nested();
  pslg.holes = {{25, 25}};
  pslg.points.push_back({26, 26});
  const Triangulation result = triangulate(pslg);
  CHECK_FALSE(result.vertex_of_input[12].has_value());
  REQUIRE(result.repairs.size() == 1);
  CHECK(result.repairs[0].find("point 12 at (26, 26)") != std::string::npos);
}

TEST_CASE("a_long_segment_through_many_points_stays_whole") {
  Pslg pslg;
  pslg.points = shapes::uniform(20'000, 5);
  pslg.points.push_back({-1, 0.5});
  pslg.points.push_back({2, 0.5000001});
  pslg.segments = {{20'000, 20'001, 3}};
  const Triangulation result = triangulate(pslg, {.keep_convex_hull = true, .progress = {}});
  shapes::require_valid(result.mesh);
  CHECK(result.mesh.constraints.size() == 1);
}

TEST_CASE("two_loops_that_touch_in_a_vertex_are_one_valid_mesh") {
  Pslg pslg;
  shapes::add_loop(pslg, shapes::box(0, 0, 2, 2));
  pslg.points.insert(pslg.points.end(), {{4, 2}, {4, 4}, {2, 4}});
  pslg.segments.insert(pslg.segments.end(), {{2, 4, 1}, {4, 5, 1}, {5, 6, 1}, {6, 2, 1}});
  const Triangulation result = triangulate(pslg);
  shapes::require_valid(result.mesh);
  CHECK(mesh::exact_area2(result.mesh) == 16);
}

}  // namespace
}  // namespace leonhard
