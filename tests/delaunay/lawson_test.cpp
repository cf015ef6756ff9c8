// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/lawson.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <string_view>
#include <variant>

#include "leonhard/delaunay/plane/exact_triangle.hpp"
#include "leonhard/delaunay/properties.hpp"
#include "leonhard/delaunay/triangulate.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/edges.hpp"
#include "tests/delaunay/flips.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

namespace criterion = delaunay::criterion;
using delaunay::PointTriangulation;
using delaunay::SwapCriterion;
using delaunay::SwapOutcome;
using delaunay::SwapReport;
using delaunay::TrianglePair;
using delaunay::TriangulateOutcome;

std::vector<Point2> distinct(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return shapes::shuffled(points, 5);
}

std::vector<SwapCriterion> all_criteria(const std::vector<double>& values) {
  return {criterion::Delaunay{},           criterion::MaxMinAngle{},
          criterion::MinMaxAngle{},        criterion::MinEdgeLength{},
          criterion::MinRoughness{values}, criterion::AngleBetweenNormals{values}};
}

void require_mesh(const TriangleMesh& mesh) {
  for (const auto& broken : {mesh::validate(mesh), mesh::validate_embedding(mesh)}) {
    INFO(broken.value_or(""));
    REQUIRE_FALSE(broken.has_value());
  }
}

delaunay::exact::Triangle at(const TriangleMesh& mesh, VertexId a, VertexId b, VertexId c) {
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

/// The largest angle's cotangent with the diagonal as it is, and with the other.
std::array<mpq_class, 2> max_angles(const TriangleMesh& mesh, const TrianglePair& p) {
  using delaunay::exact::cotangent_of_max_angle;
  return {std::min(cotangent_of_max_angle(at(mesh, p.from, p.to, p.left)),
                   cotangent_of_max_angle(at(mesh, p.to, p.from, p.right))),
          std::min(cotangent_of_max_angle(at(mesh, p.right, p.left, p.from)),
                   cotangent_of_max_angle(at(mesh, p.left, p.right, p.to)))};
}

mpq_class squared_length(const TriangleMesh& mesh, VertexId a, VertexId b) {
  const mpq_class x = mpq_class(mesh.points[a].x) - mpq_class(mesh.points[b].x),
                  y = mpq_class(mesh.points[a].y) - mpq_class(mesh.points[b].y);
  return x * x + y * y;
}

/// The sum of what AngleBetweenNormals counts over all interior edges, by an independent way: gradients from
/// a 2 x 2 system, the angle by its cosine.
long double bending(const TriangleMesh& mesh, const std::vector<double>& values) {
  PerId<TriangleId, std::array<long double, 3>> normals;
  for (const auto& [a, b, c] : mesh.corners) {
    const Vec2 u = mesh.points[b] - mesh.points[a], v = mesh.points[c] - mesh.points[a];
    const long double du = values[b.index()] - values[a.index()], dv = values[c.index()] - values[a.index()];
    const long double det = static_cast<long double>(u.x) * v.y - static_cast<long double>(u.y) * v.x;
    const long double x = (du * v.y - dv * u.y) / det, y = (u.x * dv - v.x * du) / det;
    const long double length = std::sqrt(1 + x * x + y * y);
    normals.push_back({x / length, y / length, 1 / length});
  }
  long double sum = 0;
  for (const TriangleId t : mesh.corners.ids()) {
    for (const MaybeId<TriangleId> u : mesh.neighbours[t]) {
      if (!u || *u < t) continue;
      long double cosine = 0;
      for (std::size_t i = 0; i < 3; ++i) cosine += normals[t][i] * normals[*u][i];
      sum += std::sqrt(std::max(0.0L, 2 - 2 * cosine));
    }
  }
  return sum;
}

TEST_CASE("swapping_by_the_delaunay_criterion_leads_from_any_triangulation_to_the_one") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const TriangleMesh expected = delaunay::triangulate(family.points).mesh;
    TriangleMesh mesh = shapes::scrambled(expected, 1, 60);
    const SwapReport report = delaunay::swap_edges(mesh, criterion::Delaunay{});
    CHECK(report.outcome == SwapOutcome::settled);
    require_mesh(mesh);
    CHECK(mesh.boundary == expected.boundary);
    CHECK(mesh::fingerprint(mesh) == mesh::fingerprint(expected));
    CHECK(delaunay::swap_edges(mesh, criterion::Delaunay{}).swaps == 0);

    const std::vector<Point2> points = distinct(family.points);
    PointTriangulation start = delaunay::triangulate_by_sweep(points);
    REQUIRE(start.outcome == TriangulateOutcome::done);
    REQUIRE_FALSE(start.triangulation.validate());
    require_mesh(shapes::mesh_of(start.triangulation, points));
    CHECK(delaunay::swap_edges(start.triangulation, points, criterion::Delaunay{}).outcome ==
          SwapOutcome::settled);
    CHECK(mesh::fingerprint(shapes::mesh_of(start.triangulation, points)) == mesh::fingerprint(expected));
  }
}

TEST_CASE("swapping_keeps_constraints_and_finds_the_constrained_delaunay_triangulation") {
  for (const Pslg& pslg : {shapes::nested(), shapes::comb(6, 5), shapes::fan(17, 21)}) {
    CAPTURE(pslg.source);
    const TriangleMesh expected = delaunay::triangulate(pslg).mesh;
    TriangleMesh mesh = shapes::scrambled(expected, 2, 60);
    CHECK(delaunay::swap_edges(mesh, criterion::Delaunay{}).outcome == SwapOutcome::settled);
    shapes::require_valid(mesh);
    CHECK(mesh::fingerprint(mesh) == mesh::fingerprint(expected));
  }
}

TEST_CASE("edges_between_regions_are_not_swapped") {
  TriangleMesh mesh = delaunay::triangulate(shapes::uniform(40)).mesh;
  const TrianglePair pair = shapes::convex_pairs(mesh)[7];
  mesh = shapes::flipped(mesh, pair);
  TriangleMesh divided = mesh;
  divided.regions[pair.left_triangle] = 3;
  (void)delaunay::swap_edges(divided, criterion::Delaunay{});
  auto corners = divided.corners[pair.left_triangle], expected = mesh.corners[pair.left_triangle];
  std::sort(corners.begin(), corners.end());
  std::sort(expected.begin(), expected.end());
  CHECK(corners == expected);
  require_mesh(divided);
  CHECK(delaunay::swap_edges(mesh, criterion::Delaunay{}).swaps == 1);
}

TEST_CASE("every_criterion_ends_in_a_valid_mesh_for_point_sets_of_every_degeneracy") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const std::vector<Point2> points = distinct(family.points);
    const std::vector<double> values = shapes::random_values(points.size(), 3);
    for (const SwapCriterion& chosen : all_criteria(values)) {
      CAPTURE(chosen.index());
      PointTriangulation swept = delaunay::triangulate_by_sweep(points);
      CHECK(delaunay::swap_edges(swept.triangulation, points, chosen).outcome == SwapOutcome::settled);
      CHECK(delaunay::swap_edges(swept.triangulation, points, chosen).swaps == 0);
      require_mesh(shapes::mesh_of(swept.triangulation, points));
      const PointTriangulation inserted = delaunay::triangulate_by_criterion(points, chosen);
      REQUIRE(inserted.outcome == TriangulateOutcome::done);
      require_mesh(shapes::mesh_of(inserted.triangulation, points));
      PointTriangulation again = inserted;
      CHECK(delaunay::swap_edges(again.triangulation, points, chosen).swaps == 0);
    }
  }
}

TEST_CASE("insertion_with_backward_swapping_by_the_delaunay_criterion_is_the_delaunay_triangulation") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const std::vector<Point2> points = distinct(family.points);
    const PointTriangulation result = delaunay::triangulate_by_criterion(points, criterion::Delaunay{});
    CHECK(mesh::fingerprint(shapes::mesh_of(result.triangulation, points)) ==
          mesh::fingerprint(delaunay::triangulate(points).mesh));
  }
}

TEST_CASE("no_swap_improves_what_a_criterion_leaves") {
  const std::vector<Point2> points = shapes::uniform(150);
  const std::vector<double> values = shapes::random_values(points.size(), 4);
  const TriangleMesh delaunay_mesh = delaunay::triangulate(points).mesh;
  const auto settled = [&](const SwapCriterion& chosen) {
    TriangleMesh mesh = shapes::scrambled(delaunay_mesh, 5, 80);
    CHECK(delaunay::swap_edges(mesh, chosen).swaps > 0);
    return mesh;
  };
  CHECK(mesh::fingerprint(settled(criterion::MaxMinAngle{})) == mesh::fingerprint(delaunay_mesh));
  // Rippa's theorem: the values do not matter.
  CHECK(mesh::fingerprint(settled(criterion::MinRoughness{values})) == mesh::fingerprint(delaunay_mesh));

  const TriangleMesh min_max = settled(criterion::MinMaxAngle{});
  for (const TrianglePair& pair : shapes::convex_pairs(min_max)) {
    const auto [here, swapped] = max_angles(min_max, pair);
    CHECK(here >= swapped);
  }
  const TriangleMesh shortest = settled(criterion::MinEdgeLength{});
  for (const TrianglePair& pair : shapes::convex_pairs(shortest))
    CHECK(squared_length(shortest, pair.from, pair.to) <= squared_length(shortest, pair.left, pair.right));

  const TriangleMesh flattest = settled(criterion::AngleBetweenNormals{values});
  const long double least = bending(flattest, values);
  CHECK(least < bending(delaunay_mesh, values));
  for (const TrianglePair& pair : shapes::convex_pairs(flattest))
    CHECK(bending(shapes::flipped(flattest, pair), values) > least - 1e-12L);
}

TEST_CASE("criteria_differ") {
  const std::vector<Point2> points = shapes::uniform(300, 6);
  const std::vector<double> values = shapes::random_values(points.size(), 7);
  std::vector<Fingerprint> seen;
  for (const SwapCriterion& chosen : all_criteria(values)) {
    const PointTriangulation result = delaunay::triangulate_by_criterion(points, chosen);
    seen.push_back(mesh::fingerprint(shapes::mesh_of(result.triangulation, points)));
  }
  CHECK(seen[0] == seen[1]);
  CHECK(seen[0] == seen[4]);
  CHECK(seen[0] != seen[2]);
  CHECK(seen[0] != seen[3]);
  CHECK(seen[0] != seen[5]);
  CHECK(seen[2] != seen[3]);
}

TEST_CASE("a_surface_that_is_a_ridge_gets_edges_along_the_ridge") {
  // f = |x - y| on a grid whose Delaunay diagonals all run the same way, across the ridge.
  std::vector<Point2> points = shapes::grid(6);
  std::vector<double> values;
  for (Point2& p : points) {
    values.push_back(std::abs(p.x - p.y));
    p.x += 1e-3 * p.y;  // no ties: the diagonals from top left to bottom right are the shorter ones
  }
  TriangleMesh mesh = delaunay::triangulate(points).mesh;
  const auto diagonals = [&] {
    std::size_t count = 0;
    const EdgeStructure edges = mesh::build_edges(mesh);
    for (std::size_t i = 0; i < 5; ++i)
      count += edges.find(VertexId::from(7 * i), VertexId::from(7 * i + 7)) ? 1 : 0;
    return count;
  };
  CHECK(diagonals() == 0);
  CHECK(delaunay::swap_edges(mesh, criterion::AngleBetweenNormals{values}).outcome == SwapOutcome::settled);
  CHECK(diagonals() == 5);
}

TEST_CASE("a_limit_of_swaps_and_a_stop_leave_a_valid_mesh") {
  const TriangleMesh start = shapes::scrambled(delaunay::triangulate(shapes::uniform(100)).mesh, 8, 80);
  TriangleMesh mesh = start;
  const std::size_t needed = delaunay::swap_edges(mesh, criterion::Delaunay{}).swaps;
  REQUIRE(needed > 10);
  mesh = start;
  const SwapReport limited = delaunay::swap_edges(mesh, criterion::Delaunay{}, {.max_swaps = 10});
  CHECK(limited.outcome == SwapOutcome::swap_limit);
  CHECK(limited.swaps == 10);
  require_mesh(mesh);
  std::stop_source source;
  source.request_stop();
  delaunay::SwapOptions options;
  options.progress.stop = source.get_token();
  double reported = -1;
  options.progress.report = [&](std::string_view, double fraction) { reported = fraction; };
  CHECK(delaunay::swap_edges(mesh, criterion::Delaunay{}, options).outcome == SwapOutcome::stopped);
  CHECK(reported == 0);
  require_mesh(mesh);
}

TEST_CASE("values_that_are_not_one_a_point_are_refused") {
  TriangleMesh mesh = delaunay::triangulate(shapes::uniform(10)).mesh;
  const std::vector<double> nine(9);
  CHECK_THROWS_AS((void)delaunay::swap_edges(mesh, criterion::MinRoughness{nine}), InputError);
  CHECK_THROWS_AS(
      (void)delaunay::triangulate_by_criterion(shapes::uniform(10), criterion::AngleBetweenNormals{nine}),
      InputError);
}

}  // namespace
}  // namespace leonhard
