// SPDX-License-Identifier: MIT
// Laminar flow against exact solutions and published figures.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/solver/residual.hpp"
#include "leonhard/solver/steady.hpp"
#include "tests/solver/boxes.hpp"
#include "tests/solver/meshes.hpp"
#include "tests/solver/session.hpp"

namespace {

using namespace leonhard;

constexpr auto every_cell = [](std::size_t, std::size_t) { return true; };

/// Gas between a wall at rest and one that moves with the free stream's speed, both of temperature 1, constant viscosity:
/// velocity linear, temperature 1 + Pr (gamma - 1) / 2 M^2 eta (1 - eta), pressure constant.
template <int dim>
State<dim> couette(double eta, double mach, double prandtl) {
  const double t = 1 + prandtl * 0.2 * mach * mach * eta * (1 - eta);
  solver::Axes<dim> velocity{};
  velocity[0] = mach * eta;
  return solver::state_with(1 / t, velocity, 1 / 1.4);
}

TEST_CASE("couette_flow_with_dissipation_is_exact_to_rounding") {
  test::start_petsc();
  const double mach = 0.8, prandtl = 0.72;
  const MixedMesh<2> mesh =
      test::mixed_grid(4, 10, [](double s, double t) { return Point2{0.4 * s, t}; }, every_cell);
  FlowProblem<2> problem{.dual = mesh::build_dual(mesh), .free_stream = {mach}, .vortex_correction = false};
  problem.viscosity = Viscosity{50, prandtl, -1};
  problem.outer_state = [&](Point2 p) { return couette<2>(p.y, mach, prandtl); };
  BoundaryCondition<2> still = BoundaryKind::no_slip_wall, moving = still;
  still.temperature = moving.temperature = 1.0;
  moving.wall_velocity = {mach, 0};
  problem.boundary = {{test::south, still},
                      {test::north, moving},
                      {test::west, BoundaryKind::far_field},
                      {test::east, BoundaryKind::far_field}};
  // Without the entropy fix nothing acts along the faces' planes, where the exact flow has jumps of the gradient's error only.
  const SteadyResult<2> result = solver::solve_steady(
      problem, {.limiter = LimiterKind::none, .entropy_fix = 0, .residual_drop_orders = 13, .max_iterations = 60});
  double worst = 0;
  for (const VertexId v : mesh.points.ids()) {
    const State<2> exact = couette<2>(mesh.points[v].y, mach, prandtl), &w = result.state[v];
    worst = std::max({worst, std::abs(w.rho - exact.rho), std::abs(w.u - exact.u), std::abs(w.v), std::abs(w.p - exact.p)});
  }
  CHECK(worst < 1e-8);
  // Friction 2 / Re, the same on both walls, against the moving one; its work leaves as heat through both.
  const double friction = 2 / 50.0, heat = friction / 4;
  for (const solver::WallStress<2>& stress : result.stresses) {
    const Point2 p = mesh.points[stress.at.vertex];
    if (p.x < 1e-9 || p.x > 0.4 - 1e-9) continue;
    CHECK(stress.friction[0] == doctest::Approx(p.y > 0.5 ? -friction : friction).epsilon(1e-6));
    // The moving wall's reaction takes the work, M times the force, too: -heat flows in as heat.
    CHECK(stress.heat == doctest::Approx(heat).epsilon(1e-3));
  }
  CHECK(result.forces.cd == doctest::Approx(0).epsilon(1e-9));
}

/// Quadrilaterals over a plate that begins at x = 0, finer towards its beginning and towards the wall.
MixedMesh<2> plate_mesh(std::size_t along, std::size_t up, double height) {
  return test::mixed_grid(
      along, up,
      [&](double s, double t) {
        const double x = s < 0.25 ? -0.5 * std::pow(1 - 4 * s, 2) : std::pow((s - 0.25) / 0.75, 2);
        return Point2{x, height * (std::exp(5 * t) - 1) / (std::exp(5.0) - 1)};
      },
      every_cell);
}

TEST_CASE("friction_on_a_flat_plate_is_that_of_blasius") {
  test::start_petsc();
  const double reynolds = 1e5;
  MixedMesh<2> mesh = plate_mesh(64, 48, 0.25);
  constexpr Marker upstream = 99;
  for (auto& facet : mesh.boundary)
    if (facet.marker == test::south && mesh.points[facet.corners[0]].x + mesh.points[facet.corners[1]].x < 0)
      facet.marker = upstream;
  FlowProblem<2> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.2}, .vortex_correction = false};
  problem.viscosity = Viscosity{reynolds};
  problem.boundary = {{upstream, BoundaryKind::symmetry},
                      {test::south, BoundaryKind::no_slip_wall},
                      {test::north, BoundaryKind::pressure_outflow},
                      {test::east, BoundaryKind::pressure_outflow},
                      {test::west, BoundaryKind::subsonic_inflow}};
  const SteadyResult<2> result = solver::solve_steady(problem, {.residual_drop_orders = 10});
  CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
  CHECK(result.history.back().number <= 50);
  REQUIRE(result.surface.size() == 1);
  for (const SurfacePoint& p : result.surface[0].points) {
    if (p.at.x < 0.3 || p.at.x > 0.7) continue;
    CAPTURE(p.at.x);
    CHECK(p.cf == doctest::Approx(0.6641147 / std::sqrt(reynolds * p.at.x)).epsilon(0.01));
    CHECK(p.y_plus > 0);
    CHECK(p.heat == 0);
  }
  CHECK(result.forces.cd == doctest::Approx(result.forces.cd_friction).epsilon(1e-6));
  CHECK(result.forces.cd == doctest::Approx(1.3282293 / std::sqrt(reynolds)).epsilon(0.03));
}

/// U. Ghia, K. N. Ghia and C. T. Shin, Journal of Computational Physics 48, 1982, table I: u on the vertical middle line at Re 100.
constexpr std::array<std::array<double, 2>, 7> ghia_u{
    {{0.1719, -0.10150}, {0.2813, -0.15662}, {0.4531, -0.21090}, {0.5, -0.20581}, {0.6172, -0.13641}, {0.7344, 0.00332}, {0.8516, 0.23151}}};

TEST_CASE("driven_cavity_at_reynolds_number_100_is_that_of_ghia") {
  test::start_petsc();
  const std::size_t n = 40;
  const MixedMesh<2> mesh = test::mixed_grid(n, n, [](double s, double t) { return Point2{s, t}; }, every_cell);
  const double mach = 0.1;
  FlowProblem<2> problem{.dual = mesh::build_dual(mesh), .free_stream = {mach}, .vortex_correction = false};
  problem.viscosity = Viscosity{100, 0.72, -1};
  BoundaryCondition<2> still = BoundaryKind::no_slip_wall, lid = still;
  still.temperature = lid.temperature = 1.0;
  lid.wall_velocity = {mach, 0};
  problem.boundary = {{test::south, still}, {test::east, still}, {test::north, lid}, {test::west, still}};
  const SteadyResult<2> result = solver::solve_steady(problem, {.residual_drop_orders = 8});
  CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
  for (const auto& [y, u] : ghia_u) {
    CAPTURE(y);
    const double at = y * static_cast<double>(n);
    const auto row = static_cast<std::size_t>(at);
    const auto value = [&](std::size_t j) { return result.state[VertexId::from(j * (n + 1) + n / 2)].u / mach; };
    const double share = at - static_cast<double>(row);
    CHECK((1 - share) * value(row) + share * value(row + 1) == doctest::Approx(u).epsilon(0.01).scale(1));
  }
}

TEST_CASE("couette_flow_in_space_is_that_of_the_plane") {
  test::start_petsc();
  const double mach = 0.5, prandtl = 0.72;
  const MixedMesh<3> mesh = test::box_grid({3, 3, 8}, test::BoxCells::hexahedra, [](double s, double t, double u) {
    return Point3{0.4 * s, 0.4 * t, u};
  });
  FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {mach}};
  problem.viscosity = Viscosity{50, prandtl, -1};
  problem.outer_state = [&](const Point3& p) { return couette<3>(p.z, mach, prandtl); };
  BoundaryCondition<3> still = BoundaryKind::no_slip_wall, moving = still;
  still.temperature = moving.temperature = 1.0;
  moving.wall_velocity = {mach, 0, 0};
  problem.boundary = {{test::low_z, still},
                      {test::high_z, moving},
                      {test::low_x, BoundaryKind::far_field},
                      {test::high_x, BoundaryKind::far_field},
                      {test::low_y, BoundaryKind::symmetry},
                      {test::high_y, BoundaryKind::symmetry}};
  const SteadyResult<3> result = solver::solve_steady(
      problem, {.limiter = LimiterKind::none, .entropy_fix = 0, .residual_drop_orders = 13, .max_iterations = 60});
  double worst = 0;
  for (const VertexId v : mesh.points.ids()) {
    const State<3> exact = couette<3>(mesh.points[v].z, mach, prandtl), &w = result.state[v];
    worst = std::max({worst, std::abs(w.rho - exact.rho), std::abs(w.u - exact.u), std::abs(w.v), std::abs(w.w)});
  }
  CHECK(worst < 1e-8);
}

}  // namespace
