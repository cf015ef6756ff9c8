// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>

#include "leonhard/mesh/centroid_dual.hpp"
#include "leonhard/mesh/dirichlet_dual.hpp"
#include "leonhard/mesh/median_dual.hpp"
#include "leonhard/mesh/validate.hpp"
#include "tests/mesh/shelf.hpp"

using namespace leonhard;

namespace {

/// Largest gap of any control volume relative to the length of its own boundary.
double largest_gap(const TriangleMesh& mesh, const EdgeStructure& edges, const DualMetrics<2>& dual) {
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

double sum(const PerId<VertexId, double>& areas) {
  double total = 0;
  for (const double area : areas) total += area;
  return total;
}

}  // namespace

TEST_CASE("centroid_and_dirichlet_duals_are_closed_and_have_the_meshs_area") {
  for (const shelf::Entry& entry : shelf::all()) {
    const TriangleMesh& mesh = entry.mesh;
    CAPTURE(entry.name);
    const EdgeStructure edges = mesh::build_edges(mesh);
    const double area = sum(mesh::median_dual(mesh, edges).volume);
    for (const DualMetrics<2>& dual :
         {mesh::centroid_dual(mesh, edges), static_cast<DualMetrics<2>>(mesh::dirichlet_dual(mesh, edges))}) {
      CHECK(largest_gap(mesh, edges, dual) < 1e-13);
      CHECK(sum(dual.volume) == doctest::Approx(area).epsilon(1e-12).scale(0));
    }
  }
}

TEST_CASE("centroid_normals_are_the_median_duals") {
  const TriangleMesh mesh = shelf::shaken_grid(9, 5);
  const EdgeStructure edges = mesh::build_edges(mesh);
  const DualMetrics<2> median = mesh::median_dual(mesh, edges);
  const DualMetrics<2> centroid = mesh::centroid_dual(mesh, edges);
  double apart = 0;
  for (const EdgeId e : edges.ends.ids()) CHECK(norm(median.normal[e] - centroid.normal[e]) < 1e-13);
  for (const VertexId v : mesh.points.ids())
    apart = std::max(apart, std::abs(median.volume[v] - centroid.volume[v]));
  CHECK(apart > 1e-3);  // the areas are not
}

TEST_CASE("the_dirichlet_dual_of_a_grid_has_squares_and_no_face_across_the_diagonals") {
  const TriangleMesh mesh = shelf::grid(4, 4);
  const EdgeStructure edges = mesh::build_edges(mesh);
  const DirichletDual dual = mesh::dirichlet_dual(mesh, edges);
  CHECK(dual.beyond.empty());
  CHECK(dual.volume[VertexId{12}] == 1.0);
  CHECK(dual.volume[VertexId{0}] == 0.25);
  for (const EdgeId e : edges.ends.ids()) {
    const Vec2 along = mesh.points[edges.ends[e][1]] - mesh.points[edges.ends[e][0]];
    const bool diagonal = along.x != 0 && along.y != 0;
    const Vec2 expected = diagonal ? Vec2{} : (edges.is_boundary(e) ? 0.5 : 1.0) * along;
    CHECK(norm(dual.normal[e] - expected) == 0.0);
  }
}

TEST_CASE("dirichlet_faces_are_perpendicular_to_edges_and_not_negative_in_a_delaunay_mesh") {
  const TriangleMesh mesh = shelf::grid(5, 3);
  REQUIRE_FALSE(mesh::validate_delaunay(mesh).has_value());
  const EdgeStructure edges = mesh::build_edges(mesh);
  const DirichletDual dual = mesh::dirichlet_dual(mesh, edges);
  for (const EdgeId e : edges.ends.ids()) {
    const Vec2 along = mesh.points[edges.ends[e][1]] - mesh.points[edges.ends[e][0]];
    CHECK(dot(dual.normal[e], along) >= 0);
    CHECK(std::abs(cross(dual.normal[e], along)) < 1e-15);
  }
}

TEST_CASE("a_circumcentre_beyond_the_boundary_is_told_and_counts_negative") {
  const TriangleMesh flat = shelf::build({{0, 0}, {8, 0}, {4, 1}}, {{0, 1, 2}});  // circumcentre (4, -7.5)
  const EdgeStructure edges = mesh::build_edges(flat);
  const DirichletDual dual = mesh::dirichlet_dual(flat, edges);
  REQUIRE(dual.beyond.size() == 1);
  const MarkedEdge& edge = flat.boundary[dual.beyond[0]];
  CHECK(std::minmax(edge.from, edge.to) == std::minmax(VertexId{0}, VertexId{1}));
  CHECK(dual.normal[*edges.find(VertexId{0}, VertexId{1})] == Vec2{-7.5, 0});
  CHECK(sum(dual.volume) == doctest::Approx(4.0));
  const TriangleMesh right = shelf::build({{0, 0}, {8, 0}, {0, 1}}, {{0, 1, 2}});  // on the edge: not beyond
  CHECK(mesh::dirichlet_dual(right, mesh::build_edges(right)).beyond.empty());
}
