// SPDX-License-Identifier: MIT
#include "leonhard/mesh/median_dual.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "leonhard/mesh/exact_area.hpp"
#include "leonhard/mesh/exact_volume.hpp"
#include "tests/mesh/shelves.hpp"

using namespace leonhard;
using doctest::Approx;

namespace {

/// Largest gap of any control volume relative to the size of its own boundary.
template <class Mesh>
double largest_gap(const Mesh& mesh) {
  using Kind = shelves::Kind<Mesh>;
  const auto edges = mesh::build_edges(mesh);
  const auto dual = mesh::median_dual(mesh, edges);
  REQUIRE(dual.boundary_normal.size() == mesh.boundary.size());
  PerId<VertexId, typename Kind::Vector> sum(mesh.vertex_count());
  PerId<VertexId, double> size(mesh.vertex_count());
  const auto add = [&](VertexId v, const auto& normal) {
    sum[v] = sum[v] + normal;
    size[v] += norm(normal);
  };
  for (const EdgeId e : edges.ends.ids()) {
    add(edges.ends[e][0], dual.normal[e]);
    add(edges.ends[e][1], -dual.normal[e]);
  }
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const auto corners = Kind::corners_of(mesh.boundary[i]);
    for (const VertexId v : corners)
      add(v, 1.0 / static_cast<double>(corners.size()) * dual.boundary_normal[i]);
  }
  double gap = 0;
  for (const VertexId v : sum.ids()) gap = std::max(gap, norm(sum[v]) / size[v]);
  return gap;
}

double measure_of(const TriangleMesh& mesh) { return mesh::exact_area2(mesh).get_d() / 2; }
double measure_of(const TetMesh& mesh) { return mesh::exact_volume6(mesh).get_d() / 6; }

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

DualMetrics<3> dual_of(const TetMesh& mesh) { return mesh::median_dual(mesh, mesh::build_edges(mesh)); }

Point3 mean(const std::vector<Point3>& points) {
  Vec3 sum;
  for (const Point3& p : points) sum = sum + (p - Point3{});
  return Point3{} + 1.0 / static_cast<double>(points.size()) * sum;
}

}  // namespace

TEST_CASE_TEMPLATE("control_volumes_are_closed_and_add_up_to_the_mesh_on_every_shelf", Mesh, TriangleMesh,
                   TetMesh) {
  for (const auto& entry : shelves::all<Mesh>()) {
    const Mesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    CHECK(largest_gap(mesh) < 1e-14);
    double total = 0;
    for (const double volume : mesh::median_dual(mesh, mesh::build_edges(mesh)).volume) {
      CHECK(volume > 0);
      total += volume;
    }
    CHECK(total == Approx(measure_of(mesh)).epsilon(1e-13));
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
  CHECK(sum == Approx(exact).epsilon(1e-14));
}

TEST_CASE("interior_control_volume_of_a_grid_has_one_square_of_area") {
  const auto mesh = shelf::grid(4, 4);
  const auto dual = mesh::median_dual(mesh, mesh::build_edges(mesh));
  CHECK(dual.volume[VertexId{12}] == Approx(1).epsilon(1e-15));
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
    CHECK(norm(n) == Approx(distance(mesh.points[edge.from], mesh.points[edge.to])));
    CHECK(dot(n, mesh.points[edge.from] - Point2{0.5, 0.5}) > 0);
  }
}

TEST_CASE(
    "median_dual_normals_are_the_quadrilaterals_between_midpoint_and_centroids_summed_triangle_by_triangle") {
  const TetMesh mesh = tet_shelf::shaken_box(2, 9);
  const TetEdges edges = mesh::build_edges(mesh);
  PerId<EdgeId, Vec3> expected(edges.edge_count(), Vec3{});
  for (const auto& corners : mesh.corners) {
    for (const VertexId from : corners) {
      for (const VertexId to : corners) {
        if (!(from < to)) continue;
        std::vector<Point3> rest;
        for (const VertexId v : corners)
          if (v != from && v != to) rest.push_back(mesh.points[v]);
        const Point3 a = mesh.points[from], b = mesh.points[to];
        const Point3 m = mean({a, b}), g = mean({a, b, rest[0], rest[1]});
        const Point3 f0 = mean({a, b, rest[0]}), f1 = mean({a, b, rest[1]});
        Vec3 part = 0.5 * (cross(f0 - m, g - m) + cross(g - m, f1 - m));
        if (dot(part, b - a) < 0)
          part = -part;  // the quadrilateral is seen from a's side within its tetrahedron
        Vec3& sum = expected[*edges.find(from, to)];
        sum = sum + part;
      }
    }
  }
  const DualMetrics<3> dual = mesh::median_dual(mesh, edges);
  for (const EdgeId e : edges.ends.ids()) CHECK(norm(dual.normal[e] - expected[e]) < 1e-14);
}

TEST_CASE("median_dual_of_the_unit_tetrahedron_is_that_of_arithmetic") {
  const auto mesh = tet_shelf::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  const DualMetrics<3> dual = dual_of(mesh);
  const Vec3 normal = dual.normal[EdgeId{0}];  // edge 0-1
  CHECK(normal.x == Approx(2.0 / 24));
  CHECK(normal.y == Approx(1.0 / 24));
  CHECK(normal.z == Approx(1.0 / 24));
  for (const double volume : dual.volume) CHECK(volume == Approx(1.0 / 24));
  for (std::size_t f = 0; f < 4; ++f) {
    const auto& corners = mesh.boundary[f].corners;
    if (std::count(corners.begin(), corners.end(), VertexId{0}) == 0)
      CHECK(norm(dual.boundary_normal[f] - Vec3{0.5, 0.5, 0.5}) < 1e-15);
  }
}

TEST_CASE("median_dual_far_from_the_origin_is_that_at_the_origin") {
  const TetMesh near = tet_shelf::box(2, 2, 2);
  TetMesh far = near;
  for (Point3& p : far.points) p = p + Vec3{1e15, -1e15, 0x1p50};
  const DualMetrics<3> a = dual_of(near), b = dual_of(far);
  CHECK(a.normal == b.normal);
  CHECK(a.volume == b.volume);
  CHECK(a.boundary_normal == b.boundary_normal);
}
