// SPDX-License-Identifier: MIT
#include "leonhard/mesh/median_dual.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "leonhard/mesh/exact_volume.hpp"
#include "tests/mesh/tet_shelf.hpp"

using namespace leonhard;
using doctest::Approx;

namespace {

DualMetrics<3> dual_of(const TetMesh& mesh) { return mesh::median_dual(mesh, mesh::build_edges(mesh)); }

/// The sum of the outward normals about each vertex, its thirds of the boundary included.
PerId<VertexId, Vec3> closure(const TetMesh& mesh, const TetEdges& edges, const DualMetrics<3>& dual) {
  PerId<VertexId, Vec3> sum(mesh.vertex_count(), Vec3{});
  for (const EdgeId e : edges.ends.ids()) {
    sum[edges.ends[e][0]] = sum[edges.ends[e][0]] + dual.normal[e];
    sum[edges.ends[e][1]] = sum[edges.ends[e][1]] - dual.normal[e];
  }
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    for (const VertexId v : mesh.boundary[f].corners) sum[v] = sum[v] + 1.0 / 3 * dual.boundary_normal[f];
  }
  return sum;
}

Point3 mean(const std::vector<Point3>& points) {
  Vec3 sum;
  for (const Point3& p : points) sum = sum + (p - Point3{});
  return Point3{} + 1.0 / static_cast<double>(points.size()) * sum;
}

}  // namespace

TEST_CASE("median_dual_in_space_is_closed_about_every_vertex_and_its_volumes_are_the_meshs") {
  for (const auto& entry : tet_shelf::all()) {
    const TetMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const TetEdges edges = mesh::build_edges(mesh);
    const DualMetrics<3> dual = mesh::median_dual(mesh, edges);
    REQUIRE(dual.boundary_normal.size() == mesh.boundary.size());
    for (const Vec3& sum : closure(mesh, edges, dual)) CHECK(norm(sum) < 1e-14);
    double total = 0;
    for (const double volume : dual.volume) {
      CHECK(volume > 0);
      total += volume;
    }
    CHECK(total == Approx(mesh::exact_volume6(mesh).get_d() / 6).epsilon(1e-13));
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
