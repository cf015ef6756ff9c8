// SPDX-License-Identifier: MIT
// Boundary conditions: exact channel flows, exact Jacobians, values that make no sense.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/solver/steady.hpp"
#include "leonhard/solver/sweep/boundary.hpp"
#include "tests/solver/boxes.hpp"
#include "tests/solver/meshes.hpp"
#include "tests/solver/session.hpp"

namespace {

using namespace leonhard;

TEST_CASE("channel_between_given_total_and_static_pressure_has_the_isentropic_mach_number") {
  test::start_petsc();
  const TriangleMesh mesh = test::shaken_square(10, 0.2, 2);
  FlowProblem<2> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.4}, .vortex_correction = false};
  BoundaryCondition<2> in = BoundaryKind::subsonic_inflow, out = BoundaryKind::pressure_outflow;
  in.total_pressure = 1.1, in.total_temperature = 1.2;
  out.pressure = 1.03;
  problem.boundary = {{test::west, in},
                      {test::east, out},
                      {test::south, BoundaryKind::slip_wall},
                      {test::north, BoundaryKind::symmetry}};
  const SteadyResult<2> result = solver::solve_steady(problem, {.residual_drop_orders = 11});
  CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
  const double head = 1 + 0.2 * 0.4 * 0.4, p0 = 1.1 * std::pow(head, 3.5), t0 = 1.2 * head;  // over the free stream's p and T
  const double mach = std::sqrt(5 * (std::pow(p0 / 1.03, 1 / 3.5) - 1)), t = t0 / (1 + 0.2 * mach * mach);
  for (const State<2>& w : result.state) {
    CHECK(w.p * 1.4 == doctest::Approx(1.03).epsilon(1e-8));
    CHECK(solver::mach_number({}, w) == doctest::Approx(mach).epsilon(1e-8));
    CHECK(1.4 * w.p / w.rho == doctest::Approx(t).epsilon(1e-8));
    CHECK(std::abs(w.v) < 1e-9);
  }
}

TEST_CASE("inflow_goes_where_its_direction_points") {
  test::start_petsc();
  const MixedMesh<3> mesh = test::box_grid({6, 6, 6}, test::BoxCells::tetrahedra,
                                           [](double s, double t, double u) { return Point3{s, t, u}; });
  FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.3, 0.2, 0.1}};
  BoundaryCondition<3> in = BoundaryKind::subsonic_inflow;
  in.direction = Vec3{2 * std::cos(0.2) * std::cos(0.1), 2 * std::sin(0.1), 2 * std::sin(0.2) * std::cos(0.1)};
  for (const DualFacet<3>& facet : problem.dual.boundary) problem.boundary[facet.marker] = BoundaryKind::pressure_outflow;
  for (const Marker side : {test::low_x, test::low_y, test::low_z}) problem.boundary[side] = in;
  problem.initial.resize(mesh.vertex_count());
  for (State<3>& w : problem.initial) w = {1, 0.2, 0, 0, 1 / 1.4};
  const SteadyResult<3> result = solver::solve_steady(problem, {.residual_drop_orders = 10});
  CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
  const State<3> exact = solver::free_stream_state<3>({}, problem.free_stream);
  for (const State<3>& w : result.state) {
    CHECK(w.u == doctest::Approx(exact.u).epsilon(1e-7));
    CHECK(w.v == doctest::Approx(exact.v).epsilon(1e-7));
    CHECK(w.w == doctest::Approx(exact.w).epsilon(1e-7));
  }
}

template <int dim>
void check_boundary_jacobian(const BoundaryCondition<dim>& condition, const State<dim>& w) {
  constexpr std::size_t n = dim + 2;
  solver::BoundaryCorner<dim> corner;
  corner.n[0] = 0.6, corner.n[dim - 1] = -0.8;
  corner.size = 1, corner.height = 0.3;
  corner.outer = solver::free_stream_state<dim>({}, {0.7, 0.2, 0.1});
  const solver::BoundaryConstants constants{{}, 0.05, {0.7}};
  const solver::ViscousConstants viscous{1.4, 0.02, -1, 1 / 0.72};
  double block[n * n] = {};
  solver::add_boundary_jacobian(constants, viscous, condition, corner, w, 2.0, block);
  const auto flux = [&](std::size_t j, double e) {
    solver::Conserved<dim> q = solver::conserved_of(Gas{}, w);
    q[j] += e;
    const State<dim> moved = solver::state_of(Gas{}, q);
    solver::Conserved<dim> f = solver::boundary_flux(constants, condition, corner, moved);
    const auto friction = solver::viscous_boundary_flux(viscous, condition.kind, corner, moved, nullptr);
    for (std::size_t i = 0; i < n; ++i) f[i] += friction[i];
    return f;
  };
  for (std::size_t j = 0; j < n; ++j) {
    const auto plus = flux(j, 1e-6), minus = flux(j, -1e-6);
    for (std::size_t i = 0; i < n; ++i) {
      CAPTURE(i);
      CAPTURE(j);
      CHECK(block[n * j + i] == doctest::Approx((plus[i] - minus[i]) / 1e-6).epsilon(1e-6).scale(1));
    }
  }
}

TEST_CASE("boundary_jacobians_are_exact") {
  for (const BoundaryKind kind :
       {BoundaryKind::slip_wall, BoundaryKind::no_slip_wall, BoundaryKind::far_field, BoundaryKind::supersonic_inflow,
        BoundaryKind::supersonic_outflow, BoundaryKind::subsonic_inflow, BoundaryKind::pressure_outflow, BoundaryKind::symmetry}) {
    CAPTURE(to_string(kind));
    BoundaryCondition<2> plane = kind;
    plane.total_pressure = 1.1, plane.pressure = 0.9;
    check_boundary_jacobian<2>(plane, {1.1, 0.4, 0.1, 0.8});
    check_boundary_jacobian<2>(plane, {0.9, 1.6, -1.5, 0.7});  // leaves faster than sound
    BoundaryCondition<3> space = kind;
    space.direction = Vec3{-0.5, 0.1, 0.9};
    check_boundary_jacobian<3>(space, {1.1, 0.4, 0.2, 0.1, 0.8});
  }
}

TEST_CASE("boundary_values_that_make_no_sense_are_refused_by_name") {
  const TriangleMesh mesh = test::shaken_square(4, 0, 1);
  FlowProblem<2> good{.dual = mesh::build_dual(mesh), .free_stream = {0.4}, .vortex_correction = false};
  for (const Marker side : {test::south, test::east, test::north, test::west}) good.boundary[side] = BoundaryKind::slip_wall;
  good.dual.marker_names[test::west] = "inlet";
  const auto complaint = [&](const BoundaryCondition<2>& at_inlet, bool viscous = false) -> std::string {
    FlowProblem<2> problem = good;
    problem.boundary[test::west] = at_inlet;
    if (viscous) problem.viscosity = Viscosity{-3};
    try {
      solver::check_problem(problem);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto says = [](const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; };
  CHECK(complaint(BoundaryKind::subsonic_inflow).empty());
  BoundaryCondition<2> bad = BoundaryKind::subsonic_inflow;
  bad.total_pressure = -1;
  CHECK(says(complaint(bad), "total pressure of marker"));
  CHECK(says(complaint(bad), "inlet"));
  bad = BoundaryKind::subsonic_inflow;
  bad.direction = Vec2{-1, 0};
  CHECK(says(complaint(bad), "points out of the mesh"));
  bad = BoundaryKind::pressure_outflow;
  bad.pressure = 0;
  CHECK(says(complaint(bad), "pressure of marker"));
  CHECK(says(complaint(BoundaryKind::no_slip_wall), "without viscosity"));
  CHECK(says(complaint(BoundaryKind::slip_wall, true), "reynolds"));
}

}  // namespace
