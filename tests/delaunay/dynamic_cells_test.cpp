// SPDX-License-Identifier: MIT
// Voronoi cells of a DynamicTriangulation against the whole diagram, of a DynamicTetrahedralization by Euler's formula and
// by their volumes; Sibson's weights in space as what cells lose.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/dynamic_triangulation.hpp"
#include "leonhard/delaunay/voronoi.hpp"
#include "tests/delaunay/shapes.hpp"
#include "tests/delaunay/shapes3.hpp"

namespace leonhard {
namespace {

using delaunay::DynamicTetrahedralization;
using delaunay::DynamicTriangulation;
using delaunay::Extent;
using delaunay::TetVoronoiCell;
using delaunay::VoronoiCell;

// ---- the plane ----

TEST_CASE("cells_of_the_plane_are_those_of_the_whole_diagram") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    CAPTURE(family.name);
    const std::vector<Point2> points = shapes::distinct(family.points);
    const DynamicTriangulation sites(points);
    const auto diagram = delaunay::voronoi_diagram(points);
    REQUIRE(diagram.has_value());
    for (const VertexId v : sites.vertices()) {
      VoronoiCell cell = sites.voronoi_cell(v);
      std::vector<VertexId> across;
      for (const delaunay::VoronoiEdgeId e : diagram->cell(v)) across.push_back(diagram->across(e, v));
      CHECK(cell.is_bounded() == !diagram->is_unbounded(v));
      CHECK(cell.corners.size() == diagram->cell_vertices(v).size());
      if (cell.is_bounded())  // the same loop from another begin
        std::rotate(cell.across.begin(), std::find(cell.across.begin(), cell.across.end(), across.front()),
                    cell.across.end());
      CHECK(cell.across == across);
    }
  }
}

TEST_CASE("cells_of_a_square_grid_are_squares_half_strips_and_quarters") {
  const DynamicTriangulation sites(shapes::grid(3));  // vertex 4 is the middle
  const VoronoiCell middle = sites.voronoi_cell(VertexId{4});
  CHECK(middle.is_bounded());
  CHECK(middle.corners.size() == 4);
  CHECK(middle.across.size() == 4);
  double area2 = 0;
  for (std::size_t i = 0; i < 4; ++i)
    area2 += cross(middle.corners[i].at - Point2{0, 0}, middle.corners[(i + 1) % 4].at - Point2{0, 0});
  CHECK(area2 == doctest::Approx(2));
  const VoronoiCell side = sites.voronoi_cell(VertexId{1});
  CHECK(side.corners.size() == 2);
  REQUIRE(side.rays.size() == 2);
  CHECK(side.rays[0] == Vec2{0, -1});
  CHECK(side.rays[1] == Vec2{0, -1});
  const VoronoiCell corner = sites.voronoi_cell(VertexId{0});
  REQUIRE(corner.corners.size() == 1);
  CHECK(corner.corners[0].at == Point2{0.5, 0.5});
  CHECK(corner.across == std::vector<VertexId>{VertexId{1}, VertexId{3}});
  CHECK(corner.rays == std::vector<Vec2>{{0, -1}, {-1, 0}});
}

TEST_CASE("cells_on_a_line_have_one_side_a_neighbour") {
  const DynamicTriangulation sites(std::vector<Point2>{{0, 0}, {1, 1}, {3, 3}});
  CHECK(sites.voronoi_cell(VertexId{1}).across == std::vector<VertexId>{VertexId{0}, VertexId{2}});
  CHECK(sites.voronoi_cell(VertexId{2}).across == std::vector<VertexId>{VertexId{1}});
  CHECK_FALSE(sites.voronoi_cell(VertexId{1}).is_bounded());
}

// ---- space ----

/// The edges of a cell's surface, directed, each ray as an edge to a corner at infinity of its own.
std::map<std::pair<std::size_t, std::size_t>, int> directed_edges(const TetVoronoiCell& cell) {
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  const std::size_t infinity = cell.corners.size();
  for (const TetVoronoiCell::Face& face : cell.faces) {
    for (std::size_t i = 0; i + 1 < face.corners.size(); ++i) ++edges[{face.corners[i], face.corners[i + 1]}];
    if (face.rays.empty()) {
      ++edges[{face.corners.back(), face.corners.front()}];
    } else {
      ++edges[{infinity + face.rays[0], face.corners.front()}];
      ++edges[{face.corners.back(), infinity + face.rays[1]}];
    }
  }
  return edges;
}

TEST_CASE("surfaces_of_cells_close_and_satisfy_eulers_formula_in_every_family") {
  std::size_t bounded = 0;
  for (const shapes3::NamedPoints& family : shapes3::families()) {
    CAPTURE(family.name);
    const DynamicTetrahedralization sites(family.points);
    for (const VertexId v : sites.vertices()) {
      const TetVoronoiCell cell = sites.voronoi_cell(v);
      const auto edges = directed_edges(cell);
      for (const auto& [ends, count] : edges) {
        REQUIRE(count == 1);
        REQUIRE(edges.count({ends.second, ends.first}) == 1);
      }
      std::set<std::size_t> used;
      for (const auto& face : cell.faces) {
        used.insert(face.corners.begin(), face.corners.end());
        if (!face.rays.empty()) {
          CHECK(cell.rays[face.rays[0]].corner == face.corners.front());
          CHECK(cell.rays[face.rays[1]].corner == face.corners.back());
        }
      }
      CHECK(used.size() == cell.corners.size());
      // An unbounded cell is closed by one face at infinity, which every ray leads to; with one ray, a corner is there.
      const std::size_t corners = cell.corners.size() + cell.rays.size();
      const std::size_t edge_count = edges.size() / 2 + (cell.is_bounded() ? 0 : cell.rays.size());
      const std::size_t faces = cell.faces.size() + (cell.is_bounded() ? 0 : 1);
      CHECK(corners + faces == edge_count + 2);
      CHECK(cell.is_bounded() == !sites.on_hull(v));
      bounded += cell.is_bounded() ? 1 : 0;
    }
  }
  CHECK(bounded > 300);
}

TEST_CASE("cells_of_a_cubic_grid_are_cubes_and_what_is_beyond_the_hull") {
  const DynamicTetrahedralization sites(shapes3::grid(3, 3, 3));
  const auto at = [&](const Point3& p) { return *sites.locate(p).vertices[0]; };
  const TetVoronoiCell middle = sites.voronoi_cell(at({1, 1, 1}));
  CHECK(middle.is_bounded());
  CHECK(middle.corners.size() == 8);
  CHECK(middle.faces.size() == 6);
  for (const auto& face : middle.faces) CHECK(face.corners.size() == 4);
  const TetVoronoiCell side = sites.voronoi_cell(at({1, 1, 0}));
  CHECK(side.corners.size() == 4);
  CHECK(side.faces.size() == 5);
  REQUIRE(side.rays.size() == 4);
  for (const auto& ray : side.rays) CHECK(ray.direction == Vec3{0, 0, -1});
  const TetVoronoiCell corner = sites.voronoi_cell(at({0, 0, 0}));
  REQUIRE(corner.corners.size() == 1);
  CHECK(corner.corners[0].at == Point3{0.5, 0.5, 0.5});
  CHECK(corner.faces.size() == 3);
  CHECK(corner.rays.size() == 3);
}

/// The volume of a bounded cell, by cones from its vertex.
double volume(const DynamicTetrahedralization& sites, VertexId v) {
  const TetVoronoiCell cell = sites.voronoi_cell(v);
  REQUIRE(cell.is_bounded());
  double sum = 0;
  for (const auto& face : cell.faces) {
    const auto arm = [&](std::size_t i) { return cell.corners[face.corners[i]].at - sites.point(v); };
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) sum += dot(arm(0), cross(arm(i), arm(i + 1)));
  }
  return sum / 6;
}

TEST_CASE("the_cell_of_a_cubic_grid_has_volume_1_and_cells_fill_space") {
  const DynamicTetrahedralization grid(shapes3::grid(4, 4, 4));
  for (const VertexId v : grid.vertices())
    if (!grid.on_hull(v)) CHECK(volume(grid, v) == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("sibson_weights_in_space_are_what_the_cells_around_lose") {
  // Far points keep all cells about the middle bounded.
  std::vector<Point3> points;
  for (const Point3& p : shapes3::uniform(300, 5)) points.push_back({2 * p.x - 1, 2 * p.y - 1, 2 * p.z - 1});
  for (const Point3& p : shapes3::grid(2, 2, 2)) points.push_back({40 * p.x - 20, 40 * p.y - 20, 40 * p.z - 20});
  for (const std::vector<Point3>& set : {points, shapes3::grid(6, 6, 6)}) {
    const bool is_grid = set.size() == 216;
    DynamicTetrahedralization sites(set);
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 25; ++i) {
      const double x = unit(random), y = unit(random), z = unit(random);
      Point3 p{0.6 * x - 0.3, 0.6 * y - 0.3, 0.6 * z - 0.3};
      if (is_grid) p = {2 + x, 2 + y, 2 + z};
      if (is_grid && i < 3) p = {2.5, i < 2 ? 2.5 : 2.25, i < 1 ? 2.5 : 3.0};  // inside a cube, on a face
      const auto found = sites.natural_neighbours(p);
      CAPTURE(is_grid);
      CAPTURE(i);
      REQUIRE(found.inside());
      std::map<VertexId, double> before;
      for (const auto& [v, weight] : found.weights) before[v] = volume(sites, v);
      const VertexId here = sites.insert(p).vertex;
      const double own = volume(sites, here);
      double lost = 0;
      for (const auto& [v, weight] : found.weights) {
        const double share = (before[v] - volume(sites, v)) / own;
        CHECK(weight == doctest::Approx(share).epsilon(1e-8).scale(1));
        lost += share;
      }
      CHECK(lost == doctest::Approx(1));
      sites.remove(here);
    }
  }
}

TEST_CASE("the_middle_of_a_cube_has_eight_equal_weights_and_faces_of_the_hull_are_linear") {
  const DynamicTetrahedralization cube(shapes3::grid(2, 2, 2));
  const auto middle = cube.natural_neighbours({0.5, 0.5, 0.5});
  REQUIRE(middle.weights.size() == 8);
  for (const auto& [v, weight] : middle.weights) CHECK(weight == doctest::Approx(0.125).epsilon(1e-14));
  const std::vector<double> values{0, 1, 2, 3, 4, 5, 6, 7};
  const DynamicTetrahedralization tet(
      std::vector<Point3>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}});
  using Kind = delaunay::TetLocation::Kind;
  for (const bool natural : {false, true}) {
    const auto at = [&](const Point3& p) {
      return natural ? tet.interpolate_natural_neighbour(p, values) : tet.interpolate_linear(p, values);
    };
    CHECK(at({1, 1, 1}).where == Kind::on_vertex);
    CHECK(at({1, 1, 1}).value == 4);
    CHECK(at({1, 0, 0}).where == Kind::on_edge);
    CHECK(at({1, 0, 0}).value == 0.25);
    CHECK(at({1, 1, 0}).where == Kind::on_face);
    CHECK(at({1, 1, 0}).value == 0.75);
    CHECK(at({1, 1, 2}).where == Kind::on_face);
    CHECK(at({1, 1, 2}).value == 0.25 + 0.5 + 1.5);
    CHECK(at({0.5, 0.5, 0.5}).where == Kind::on_edge);
    CHECK(at({-1e-300, 1, 1}).where == Kind::outside);
    CHECK(std::isnan(at({-1e-300, 1, 1}).value));
  }
  CHECK(tet.interpolate_linear({0.5, 0.5, 0.5}, values).value == 2);
}

TEST_CASE("sibson_weights_on_a_flat_part_of_the_hull_are_those_of_the_plane") {
  // Into a tilted plane, by steps of (2, 1, 2) and (-2, 2, 1), both of length 3; (-1, -2, 2) is its normal.
  const auto lifted = [](Point2 p) { return Point3{2 * p.x - 2 * p.y, p.x + 2 * p.y, 2 * p.x + p.y}; };
  const auto inwards = [](const Point3& p, double h) { return p + h * Vec3{-1, -2, 2}; };
  for (const bool is_grid : {false, true}) {
    std::vector<Point2> flat =
        is_grid ? shapes::grid(5) : std::vector<Point2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    if (!is_grid)  // on a coarse grid of doubles, so that the lifted points lie exactly in a plane
      for (const Point2 p : shapes::uniform(40, 3))
        flat.push_back({std::round(p.x * 4096) / 1024, std::round(p.y * 4096) / 1024});
    flat = shapes::distinct(flat);
    std::vector<Point3> points;
    for (const Point2 p : flat) points.push_back(lifted(p));
    for (const Point2 p : shapes::uniform(30, 9))
      points.push_back(inwards(lifted({4 * p.x, 4 * p.y}), 0.5 + p.x));
    const DynamicTriangulation plane(flat);
    const DynamicTetrahedralization space(points);
    for (const Point2 q : shapes::uniform(30, 4)) {
      const Point2 p{std::round(q.x * 1024) / 256, std::round(q.y * 1024) / 256};
      if (!(p.x > 0 && p.y > 0 && p.x < 4 && p.y < 4)) continue;
      const auto expected = plane.natural_neighbours(p);
      const auto found = space.natural_neighbours(lifted(p));
      std::map<VertexId, double> of_vertex;
      for (const auto& [v, weight] : expected.weights) of_vertex[v] = weight;
      for (const auto& [v, weight] : found.weights) {
        REQUIRE(v.index() < flat.size());
        CHECK(weight == doctest::Approx(of_vertex[v]).epsilon(1e-10).scale(1));
      }
    }
  }
}

TEST_CASE("the_nearest_of_vertices_on_a_line_in_space_is_found_without_looking_at_all") {
  std::vector<Point3> line;
  for (int i = 0; i < 50; ++i) line.push_back({3.0 * i, -7.0 * i, 1.0 * i});
  const DynamicTetrahedralization sites(shapes3::shuffled(line, 3));
  REQUIRE(sites.extent() == Extent::line);
  for (const Point3& p : shapes3::transformed(shapes3::uniform(200, 4), 400, -200)) {
    const auto nearer = [&](const Point3& a, const Point3& b) { return norm(a - p) < norm(b - p); };
    CHECK(sites.point(*sites.nearest_vertex(p)) == *std::min_element(line.begin(), line.end(), nearer));
  }
  CHECK(sites.point(*sites.nearest_vertex({1.5, -3.5, 0.5})) == Point3{0, 0, 0});  // half way
}

}  // namespace
}  // namespace leonhard
