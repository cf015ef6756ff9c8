// SPDX-License-Identifier: MIT
#include "leonhard/mesh/median_dual.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

/// Largest gap of any control volume relative to the length of its own boundary.
double largest_gap(const TriangleMesh& mesh) {
  const EdgeStructure edges = mesh::build_edges(mesh);
  const DualMetrics<2> dual = mesh::median_dual(mesh, edges);
  PerId<VertexId, Vec2> sum(mesh.vertex_count());
  PerId<VertexId, double> length(mesh.vertex_count());
  const auto add = [&](VertexId v, Vec2 normal) {
    sum[v] = sum[v] + normal;
    length[v] += norm(normal);
  };
  for (const EdgeId e : edges.ends.ids()) {
    add(edges.ends[e][0], dual.normal[e]);
    add(edges.ends[e][1], -dual.normal[e]);
  }
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    add(mesh.boundary[i].from, 0.5 * dual.boundary_normal[i]);
    add(mesh.boundary[i].to, 0.5 * dual.boundary_normal[i]);
  }
  double gap = 0;
  for (const VertexId v : sum.ids()) gap = std::max(gap, norm(sum[v]) / length[v]);
  return gap;
}

/// The normal between two centroids by way of the midpoint, from the definition.
Vec2 normal_from_definition(const TriangleMesh& mesh, const EdgeStructure& edges, EdgeId e) {
  const Point2 a = mesh.points[edges.ends[e][0]], b = mesh.points[edges.ends[e][1]];
  const Point2 middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
  Vec2 sum;
  for (const std::size_t side : {0, 1}) {
    if (!edges.sides[e][side]) continue;
    Point2 centroid;
    for (const VertexId v : mesh.corners[*edges.sides[e][side]]) {
      centroid = centroid + 1.0 / 3 * Vec2{mesh.points[v].x, mesh.points[v].y};
    }
    const Vec2 way = side == 0 ? centroid - middle : middle - centroid;  // from right to left
    sum = sum + Vec2{way.y, -way.x};
  }
  return sum;
}

}  // namespace

TEST_CASE("control_volumes_are_closed_to_rounding_on_every_mesh_of_the_shelf") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    CHECK(largest_gap(mesh) < 1e-14);
  }
}

TEST_CASE("control_volumes_stay_closed_far_from_the_origin_and_at_any_scale") {
  CHECK(largest_gap(shelf::shaken_grid(12, 3, 1e-9)) < 1e-14);
  CHECK(largest_gap(shelf::shaken_grid(12, 3, 1e9)) < 1e-14);
  CHECK(largest_gap(shelf::shaken_grid(12, 4, 1, {1e12, -1e12})) < 1e-14);
}

TEST_CASE("areas_of_control_volumes_add_up_to_the_mesh") {
  const auto mesh = shelf::annulus(64);
  const auto dual = mesh::median_dual(mesh, mesh::build_edges(mesh));
  double sum = 0;
  for (const double area : dual.volume) sum += area;
  const double exact =
      64 * 0.5 * std::sin(2 * std::numbers::pi / 64) * (2 * 2 - 1 * 1);  // two regular polygons
  CHECK(sum == doctest::Approx(exact).epsilon(1e-14));
}

TEST_CASE("interior_control_volume_of_a_grid_has_one_square_of_area") {
  const auto mesh = shelf::grid(4, 4);
  const auto dual = mesh::median_dual(mesh, mesh::build_edges(mesh));
  CHECK(dual.volume[VertexId{12}] == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("normals_are_those_of_the_definition_and_point_from_the_first_end") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const EdgeStructure edges = mesh::build_edges(mesh);
    const DualMetrics<2> dual = mesh::median_dual(mesh, edges);
    for (const EdgeId e : edges.ends.ids()) {
      const Vec2 expected = normal_from_definition(mesh, edges, e);
      CHECK(norm(dual.normal[e] - expected) < 1e-14);
    }
  }
  const auto triangle = shelf::build({{0, 0}, {2, 0}, {1, 3}}, {{0, 1, 2}});
  const auto dual = mesh::median_dual(triangle, mesh::build_edges(triangle));
  CHECK(dual.normal[EdgeId{0}] == Vec2{1, 0});  // edge 0-1, face from (1, 0) to (1, 1)
}

TEST_CASE("boundary_normals_point_outward_with_the_edges_length") {
  const auto mesh = shelf::build({{0, 0}, {3, 0}, {0, 4}}, {{0, 1, 2}});
  const auto dual = mesh::median_dual(mesh, mesh::build_edges(mesh));
  REQUIRE(dual.boundary_normal.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& edge = mesh.boundary[i];
    const Vec2 n = dual.boundary_normal[i];
    CHECK(norm(n) == doctest::Approx(distance(mesh.points[edge.from], mesh.points[edge.to])));
    CHECK(dot(n, mesh.points[edge.from] - Point2{0.5, 0.5}) > 0);
  }
}
