// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/properties.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>

#include "leonhard/delaunay/constrained/visibility.hpp"
#include "leonhard/delaunay/plane/exact_triangle.hpp"
#include "leonhard/delaunay/topology/interior_edges.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/quality.hpp"
#include "leonhard/mesh/topology.hpp"
#include "tests/delaunay/flips.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::TrianglePair;
using shapes::convex_pairs;
using shapes::flipped;
using shapes::random_values;
using shapes::scrambled;

void check_holds(const std::optional<std::string>& problem) {
  INFO(problem.value_or(""));
  CHECK_FALSE(problem.has_value());
}

/// A pair whose circumcircle holds the fourth corner, not just touches it, once flipped.
TriangleMesh with_one_bad_edge(const TriangleMesh& mesh) {
  for (const TrianglePair& pair : convex_pairs(mesh)) {
    const auto& p = mesh.points;
    if (kernel::incircle(p[pair.from], p[pair.to], p[pair.left], p[pair.right]) == Sign::negative)
      return flipped(mesh, pair);
  }
  FAIL("all pairs are cocircular");
  return mesh;
}

/// A rhombus, four times as wide as high, with its short diagonal or its long one.
TriangleMesh rhombus(bool short_diagonal) {
  const PerId<VertexId, Point2> points(std::vector<Point2>{{-4, 0}, {0, -1}, {4, 0}, {0, 1}});
  const VertexId w{0}, s{1}, e{2}, n{3};
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  corners.push_back(short_diagonal ? std::array{w, s, n} : std::array{w, s, e});
  corners.push_back(short_diagonal ? std::array{s, e, n} : std::array{w, e, n});
  return mesh::make_triangle_mesh(points, corners, {{w, s, 1}, {s, e, 1}, {e, n, 1}, {n, w, 1}});
}

TEST_CASE("all_seven_properties_hold_for_point_sets_of_every_degeneracy") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const TriangleMesh mesh = delaunay::triangulate(family.points).mesh;
    const std::vector<double> values = random_values(mesh.vertex_count(), 1);
    check_holds(delaunay::validate_uniqueness(mesh));
    check_holds(delaunay::validate_circumcircles(mesh));
    check_holds(delaunay::validate_edge_circles(mesh));
    check_holds(delaunay::validate_constrained_edge_circles(mesh));
    check_holds(delaunay::validate_equiangularity(mesh));
    check_holds(delaunay::validate_nearest_neighbours(mesh));
    check_holds(delaunay::validate_roughness(mesh, values));
    const TriangleMesh other = scrambled(mesh, 3, 40);
    check_holds(delaunay::validate_min_angle(mesh, other));
    check_holds(delaunay::validate_containment_circles(mesh, other));
    check_holds(delaunay::validate_roughness(mesh, other, values));
  }
}

TEST_CASE("one_swapped_edge_is_refused_by_the_checks_of_pairs_and_circles") {
  std::vector<TriangleMesh> meshes{delaunay::triangulate(shapes::uniform(60)).mesh,
                                   delaunay::triangulate(shapes::families()[8].points).mesh, rhombus(true)};
  for (const TriangleMesh& mesh : meshes) {
    const TriangleMesh bad = with_one_bad_edge(mesh);
    CHECK(delaunay::validate_uniqueness(bad));
    CHECK(delaunay::validate_circumcircles(bad));
    CHECK(delaunay::validate_edge_circles(bad));
    CHECK(delaunay::validate_constrained_edge_circles(bad));
    CHECK(delaunay::validate_equiangularity(bad));
    CHECK(delaunay::validate_roughness(bad, random_values(bad.vertex_count(), 2)));
  }
}

TEST_CASE("a_long_diagonal_of_a_rhombus_is_refused_by_the_checks_of_the_whole") {
  const TriangleMesh good = rhombus(true), bad = rhombus(false);
  const std::vector<double> values{0, 1, 0, 1};
  CHECK(delaunay::validate_min_angle(bad, good));
  CHECK(delaunay::validate_containment_circles(bad, good));
  CHECK(delaunay::validate_nearest_neighbours(bad));
  CHECK(delaunay::validate_roughness(bad, good, values));
  check_holds(delaunay::validate_min_angle(good, bad));
  check_holds(delaunay::validate_containment_circles(good, bad));
  check_holds(delaunay::validate_nearest_neighbours(good));
  check_holds(delaunay::validate_roughness(good, bad, values));
  CHECK(delaunay::validate_containment_circles(bad, good)->find("radius 4 ") != std::string::npos);
  CHECK(delaunay::validate_nearest_neighbours(bad)->find("vertex 3 at (0, 1)") != std::string::npos);
  // A linear function is as rough in every triangulation.
  CHECK_FALSE(delaunay::validate_roughness(bad, good, std::vector<double>{-4, 0, 4, 0}));
}

TEST_CASE("ties_are_named_and_only_the_perturbed_choice_is_the_one_triangulation") {
  CHECK_FALSE(delaunay::first_tie(delaunay::triangulate(shapes::uniform(60)).mesh));
  const TriangleMesh grid = delaunay::triangulate(shapes::grid(4)).mesh;
  REQUIRE(delaunay::first_tie(grid));
  CHECK(delaunay::first_tie(grid)->find("lies on the circumcircle of triangle") != std::string::npos);
  const auto& p = grid.points;
  for (const TrianglePair& pair : convex_pairs(grid)) {
    if (kernel::incircle(p[pair.from], p[pair.to], p[pair.left], p[pair.right]) != Sign::zero) continue;
    const TriangleMesh other = flipped(grid, pair);
    CHECK(delaunay::validate_uniqueness(other));
    check_holds(delaunay::validate_circumcircles(other));
    check_holds(delaunay::validate_edge_circles(other));
    check_holds(delaunay::validate_equiangularity(other));
  }
}

TEST_CASE("constraints_take_the_vertices_behind_them_out_of_edge_circles") {
  // As in figure 3.2.2 of the notes: d is near a-c, but behind the constraint a-b.
  Pslg pslg;
  pslg.points = {{0, 0}, {8, 1}, {8, -5}, {4, 1.5}, {0, 6}};
  pslg.segments = {{0, 1, 7}};
  delaunay::TriangulateOptions options;
  options.keep_convex_hull = true;
  const TriangleMesh mesh = delaunay::triangulate(pslg, options).mesh;
  REQUIRE(mesh.constraints.size() == 1);
  check_holds(delaunay::validate_constrained_edge_circles(mesh));
  TriangleMesh unconstrained = mesh;
  unconstrained.constraints.clear();
  CHECK(delaunay::validate_constrained_edge_circles(unconstrained));
  CHECK(delaunay::validate_edge_circles(mesh));
}

TEST_CASE("constrained_meshes_have_constrained_edge_circles_and_swapped_edges_have_none") {
  for (const Pslg& pslg : {shapes::nested(), shapes::comb(6, 5), shapes::fan(17, 21)}) {
    CAPTURE(pslg.source);
    const TriangleMesh mesh = delaunay::triangulate(pslg).mesh;
    check_holds(delaunay::validate_constrained_edge_circles(mesh));
    for (const TrianglePair& pair : convex_pairs(mesh)) {
      const auto& p = mesh.points;
      if (kernel::incircle(p[pair.from], p[pair.to], p[pair.left], p[pair.right]) != Sign::negative) continue;
      CHECK(delaunay::validate_constrained_edge_circles(flipped(mesh, pair)));
    }
  }
}

TEST_CASE("walls_hide_edges_unless_they_leave_a_gap") {
  using delaunay::sees_edge;
  using Walls = std::vector<delaunay::Wall>;
  const Point2 p{0, 4}, a{-2, 0}, b{2, 0};
  CHECK(sees_edge(p, a, b, Walls{}));
  CHECK_FALSE(sees_edge(p, a, b, Walls{{Point2{-1, 2}, Point2{1, 2}}}));
  CHECK_FALSE(sees_edge(p, b, a, Walls{{Point2{-1, 2}, Point2{1, 2}}}));
  CHECK(sees_edge(p, a, b, Walls{{Point2{-1, 2}, Point2{0.9375, 2}}}));
  // Two walls that meet leave no gap, two at different heights may.
  CHECK_FALSE(sees_edge(p, a, b, Walls{{Point2{-1, 2}, Point2{0, 3}}, {Point2{0, 3}, Point2{3, 1}}}));
  CHECK_FALSE(sees_edge(p, a, b, Walls{{Point2{-1, 2}, Point2{0, 1}}, {Point2{0, 3}, Point2{3, 2}}}));
  CHECK(sees_edge(p, a, b, Walls{{Point2{-1, 2}, Point2{-0.25, 3}}, {Point2{0, 3}, Point2{3, 2}}}));
  // A wall along a line of sight, and walls beside and behind, hide nothing.
  CHECK(sees_edge(p, a, b,
                  Walls{{p, Point2{0, 1}}, {p, Point2{5, 4}}, {Point2{-3, -1}, Point2{3, -1}}, {a, p}}));
  CHECK_FALSE(sees_edge(p, a, b, Walls{{a, Point2{5, 3}}}));
}

TEST_CASE("exact_figures_of_a_triangle_are_those_of_its_quality") {
  using delaunay::exact::Triangle;
  const Triangle right{Point2{0, 0}, Point2{3, 0}, Point2{0, 4}};
  CHECK(delaunay::exact::cotangent_of_min_angle(right) == mpq_class(4, 3));
  CHECK(delaunay::exact::cotangent_of_max_angle(right) == 0);
  CHECK(delaunay::exact::squared_containment_radius(right) == mpq_class(25, 4));
  CHECK(delaunay::exact::squared_containment_radius({Point2{0, 0}, Point2{4, 0}, Point2{2, 1}}) == 4);
  CHECK(delaunay::exact::squared_containment_radius({Point2{0, 0}, Point2{4, 0}, Point2{2, 4}}) ==
        mpq_class(25, 4));
  // f = 2x - 3y: |grad f|^2 = 13, area 6.
  CHECK(delaunay::exact::roughness(right, {0, 6, -12}) == 78);
  const TriangleQuality quality = mesh::triangle_quality(right[0], right[1], right[2]);
  CHECK(std::atan2(1.0, 4.0 / 3.0) * 180 / std::numbers::pi == doctest::Approx(quality.min_angle_deg));
}

TEST_CASE("other_points_and_missing_values_are_refused") {
  const TriangleMesh mesh = rhombus(true), other = delaunay::triangulate(shapes::uniform(4)).mesh;
  CHECK_THROWS_AS((void)delaunay::validate_min_angle(mesh, other), InputError);
  CHECK_THROWS_AS((void)delaunay::validate_containment_circles(mesh, other), InputError);
  CHECK_THROWS_AS((void)delaunay::roughness(mesh, std::vector<double>(3)), InputError);
}

TEST_CASE("nearest_neighbours_of_many_points_are_joined") {
  check_holds(delaunay::validate_nearest_neighbours(delaunay::triangulate(shapes::uniform(5000)).mesh));
  std::vector<Point2> upright;
  for (Point2 p : shapes::uniform(5000)) upright.push_back({p.x * 1e-3, p.y});
  check_holds(delaunay::validate_nearest_neighbours(delaunay::triangulate(upright).mesh));
}

TEST_CASE("nearest_neighbours_are_those_of_a_search_through_all_vertices") {
  const auto all_joined = [](const TriangleMesh& mesh) {
    const EdgeStructure edges = mesh::build_edges(mesh);
    for (const VertexId v : mesh.points.ids()) {
      std::vector<VertexId> others;
      for (const VertexId w : mesh.points.ids())
        if (w != v) others.push_back(w);
      const auto nearer = [&](VertexId a, VertexId b) {
        return kernel::compare_distance(mesh.points[v], mesh.points[a], mesh.points[b]) == Sign::negative;
      };
      const VertexId nearest = *std::min_element(others.begin(), others.end(), nearer);
      for (const VertexId w : others)
        if (!nearer(nearest, w) && !edges.find(v, w)) return false;
    }
    return true;
  };
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const std::vector<Point2> points = seed % 2 == 0 ? shapes::grid(3) : shapes::uniform(9, seed);
    const TriangleMesh mesh = scrambled(delaunay::triangulate(points).mesh, seed, 4);
    CAPTURE(seed);
    CHECK(all_joined(mesh) == !delaunay::validate_nearest_neighbours(mesh).has_value());
  }
}

}  // namespace
}  // namespace leonhard
