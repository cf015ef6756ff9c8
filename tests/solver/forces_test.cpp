// SPDX-License-Identifier: MIT
#include "leonhard/solver/forces.hpp"

#include <doctest/doctest.h>

#include "tests/solver/meshes.hpp"

namespace {

using namespace leonhard;

Point2 circle(double turn) {
  const double angle = 2 * std::numbers::pi * turn;
  return {0.5 + 0.5 * std::cos(angle), 0.5 * std::sin(angle)};
}

FlowProblem<2> about(const TriangleMesh& mesh, double alpha_rad) {
  return {mesh::build_dual(mesh),
          {},
          {0.5, alpha_rad},
          {{test::south, BoundaryKind::slip_wall}, {test::north, BoundaryKind::far_field}},
          {},
          true,
          {0.25, 0},
          {}};
}

double polygon_area(const SurfaceLine& line) {
  double twice = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Point2 a = line.points[i].at, b = line.points[(i + 1) % line.points.size()].at;
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::abs(twice);
}

TEST_CASE("uniform_pressure_gives_no_force_on_a_closed_body") {
  const TriangleMesh mesh = test::o_mesh(40, 6, 5, 0.1, circle);
  const FlowProblem<2> problem = about(mesh, 0.3);
  const Forces forces =
      solver::total(solver::wall_forces(problem, PerId<VertexId, State<2>>(mesh.vertex_count(), {1, 0, 0, 3})));
  CHECK(std::abs(forces.cl) < 1e-13);
  CHECK(std::abs(forces.cd) < 1e-13);
  CHECK(std::abs(forces.cm) < 1e-13);
}

TEST_CASE("pressure_growing_downwards_lifts_a_body_by_its_area") {
  // Archimedes: p = -y gives the force (0, area) exactly for a polygon with the trapezoidal rule.
  const TriangleMesh mesh = test::o_mesh(40, 6, 5, 0.1, circle);
  PerId<VertexId, State<2>> state;
  for (const Point2 p : mesh.points) state.push_back({1, 0, 0, 2 - p.y});
  const FlowProblem<2> level = about(mesh, 0);
  const auto lines = solver::surface_lines(level, state);
  REQUIRE(lines.size() == 1);
  const double area = polygon_area(lines[0]), scale = 1 / (0.5 * 0.25);
  const Forces forces = solver::total(solver::wall_forces(level, state));
  CHECK(forces.cl == doctest::Approx(scale * area).epsilon(1e-12));
  CHECK(std::abs(forces.cd) < 1e-12);
  // It acts at the centre (0.5, 0), behind the moment centre (0.25, 0): nose down.
  CHECK(forces.cm == doctest::Approx(-0.25 * scale * area).epsilon(1e-10));
  const Forces turned = solver::total(solver::wall_forces(about(mesh, 0.3), state));
  CHECK(turned.cl == doctest::Approx(scale * area * std::cos(0.3)).epsilon(1e-12));
  CHECK(turned.cd == doctest::Approx(scale * area * std::sin(0.3)).epsilon(1e-12));
}

TEST_CASE("surface_lines_run_once_around_a_body_from_the_trailing_edge") {
  const TriangleMesh mesh = test::o_mesh(40, 6, 5, 0.1, circle);
  const auto lines = solver::surface_lines(about(mesh, 0),
                                           PerId<VertexId, State<2>>(mesh.vertex_count(), {1, 0.5, 0, 1 / 1.4}));
  REQUIRE(lines.size() == 1);
  const SurfaceLine& line = lines[0];
  CHECK(line.closed);
  CHECK(line.marker == test::south);
  REQUIRE(line.points.size() == 40);
  CHECK(line.points[0].at.x == doctest::Approx(1));
  CHECK(line.points[0].arc_length == 0);
  for (std::size_t i = 1; i < 40; ++i) {
    const double way = distance(line.points[i - 1].at, line.points[i].at);
    CHECK(line.points[i].arc_length - line.points[i - 1].arc_length == doctest::Approx(way));
    CHECK(way < 0.09);  // consecutive points are neighbours on the circle
  }
  CHECK(line.points[7].cp == doctest::Approx(0).epsilon(1e-12));
  CHECK(line.points[7].mach == doctest::Approx(0.5));
}

TEST_CASE("surface_lines_of_an_open_wall_keep_both_ends") {
  const TriangleMesh mesh = test::mapped_grid(8, 4, false, [](double s, double t) { return Point2{s, t}; });
  FlowProblem<2> problem{mesh::build_dual(mesh), {}, {2, 0}, {}, {}, true, {}, {}};
  problem.boundary = {{test::south, BoundaryKind::slip_wall},
                      {test::east, BoundaryKind::supersonic_outflow},
                      {test::north, BoundaryKind::symmetry},
                      {test::west, BoundaryKind::supersonic_inflow}};
  const auto lines =
      solver::surface_lines(problem, PerId<VertexId, State<2>>(mesh.vertex_count(), {1, 2, 0, 1 / 1.4}));
  REQUIRE(lines.size() == 1);
  CHECK(!lines[0].closed);
  CHECK(lines[0].points.size() == 9);
  CHECK(lines[0].points.back().arc_length == doctest::Approx(1));
}

}  // namespace
