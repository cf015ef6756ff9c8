// SPDX-License-Identifier: MIT
// The solver in space.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/mesh/validate.hpp"
#include "leonhard/solver/residual.hpp"
#include "leonhard/solver/steady.hpp"
#include "tests/solver/boxes.hpp"
#include "tests/solver/meshes.hpp"
#include "tests/solver/session.hpp"

namespace {

using namespace leonhard;
using solver::FlowResidual;
using test::BoxCells;

constexpr BoxCells every_kind[] = {BoxCells::tetrahedra, BoxCells::hexahedra, BoxCells::prisms};

MixedMesh<3> shaken_box(std::array<std::size_t, 3> cells, BoxCells kind) {
  return test::box_grid(cells, kind, [](double s, double t, double u) { return test::shaken_cube(s, t, u, 0.015); });
}

template <int dim>
void set_all_sides(FlowProblem<dim>& problem, const BoundaryCondition<dim>& condition) {
  for (const DualFacet<dim>& facet : problem.dual.boundary) problem.boundary[facet.marker] = condition;
}

/// States of which no two are alike, physical.
PerId<VertexId, State<3>> rough_states(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-0.1, 0.1);
  PerId<VertexId, State<3>> state;
  for (std::size_t i = 0; i < count; ++i)
    state.push_back({1 + off(random), 0.5 + off(random), off(random), off(random), 0.7 + off(random)});
  return state;
}

double largest(const std::vector<double>& numbers, std::size_t count) {
  double most = 0;
  for (std::size_t i = 0; i < count; ++i) most = std::max(most, std::abs(numbers[i]));
  return most;
}

TEST_CASE("free_stream_is_kept_to_rounding_on_each_kind_of_cell_in_space") {
  for (const BoxCells kind : every_kind) {
    const MixedMesh<3> mesh = shaken_box({7, 6, 5}, kind);
    REQUIRE_MESSAGE(!mesh::validate(mesh), mesh::validate(mesh).value_or(""));
    for (const bool viscous : {false, true}) {
      FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.7, 0.3, 0.2}};
      if (viscous) problem.viscosity = Viscosity{100};
      set_all_sides<3>(problem, BoundaryKind::far_field);
      std::vector<double> out;
      FlowResidual<3>(problem, {})
          .evaluate(PerId<VertexId, State<3>>(mesh.vertex_count(), solver::free_stream_state<3>({}, {0.7, 0.3, 0.2})), out);
      CHECK(largest(out, 5 * mesh.vertex_count()) < 1e-13);
    }
  }
}

TEST_CASE("residual_in_space_has_the_same_bits_for_any_thread_count_and_kernel_build") {
  const MixedMesh<3> mesh = shaken_box({24, 20, 18}, BoxCells::tetrahedra);
  FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.5}, .viscosity = Viscosity{200}};
  set_all_sides<3>(problem, BoundaryKind::far_field);
  problem.boundary[test::low_z] = BoundaryKind::no_slip_wall;
  const auto state = rough_states(mesh.vertex_count());
  const std::size_t numbers = 5 * mesh.vertex_count();
  std::vector<double> one, other;
  FlowResidual<3> reference(problem, {}, solver::SweepBuilds<3>::baseline);
  REQUIRE(reference.plan().parts.size() > 3);
  reference.evaluate(state, one);
  for (const int threads : {1, 2, 3})
    for (const auto* kernels : {&solver::SweepBuilds<3>::baseline, &solver::best_sweep<3>()}) {
      solver::SpatialOptions options;
      options.threads = threads;
      FlowResidual<3>(problem, options, *kernels).evaluate(state, other);
      CHECK(std::equal(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(numbers), other.begin()));
    }
}

TEST_CASE("interior_fluxes_cancel_in_space") {
  const MixedMesh<3> mesh = shaken_box({6, 5, 4}, BoxCells::prisms);
  FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.5}};
  set_all_sides<3>(problem, BoundaryKind::slip_wall);
  std::vector<double> out;
  FlowResidual<3>(problem, {}).evaluate(rough_states(mesh.vertex_count()), out);
  for (const std::size_t conserved : {0u, 4u}) {  // mass and energy: nothing goes through walls
    double sum = 0;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) sum += out[5 * v + conserved];
    CHECK(std::abs(sum) < 1e-13);
  }
}

/// The first-order residual by conservative variables, times a direction, by central differences.
std::vector<double> difference(FlowResidual<3>& residual, const PerId<VertexId, State<3>>& state,
                               const std::vector<double>& direction) {
  const double e = 1e-6;
  std::vector<double> plus, minus;
  const auto moved = [&](double sign) {
    PerId<VertexId, State<3>> to;
    for (const VertexId v : state.ids()) {
      solver::Conserved<3> q = solver::conserved_of(Gas{}, state[v]);
      for (std::size_t i = 0; i < 5; ++i) q[i] += sign * e * direction[5 * v.index() + i];
      to.push_back(solver::state_of(Gas{}, q));
    }
    return to;
  };
  residual.evaluate_first_order(moved(1), plus);
  residual.evaluate_first_order(moved(-1), minus);
  for (std::size_t i = 0; i < direction.size(); ++i) plus[i] = (plus[i] - minus[i]) / (2 * e);
  return plus;
}

TEST_CASE("jacobian_in_space_is_near_the_differences_of_the_first_order_residual") {
  // Rusanov's speed and the viscosity are held fixed in the Jacobian: about a uniform state that leaves an error of second order.
  const MixedMesh<3> mesh = shaken_box({4, 4, 4}, BoxCells::tetrahedra);
  FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.5}, .viscosity = Viscosity{50, 0.72, -1}};
  set_all_sides<3>(problem, BoundaryKind::far_field);
  problem.boundary[test::low_x] = BoundaryKind::subsonic_inflow;
  problem.boundary[test::high_x] = BoundaryKind::pressure_outflow;
  problem.boundary[test::low_y] = BoundaryKind::symmetry;
  problem.boundary[test::high_z] = BoundaryKind::supersonic_outflow;
  BoundaryCondition<3> moving = BoundaryKind::no_slip_wall;
  moving.wall_velocity = {0.5, 0, 0}, moving.temperature = 1.0;
  problem.boundary[test::low_z] = moving;
  FlowResidual<3> residual(problem, {.flux = FluxKind::rusanov});
  const PerId<VertexId, State<3>> state(mesh.vertex_count(), solver::free_stream_state<3>({}, {0.5}));
  std::vector<double> blocks(25 * residual.plan().block_count());
  residual.jacobian(state, blocks);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> spread(-1, 1);
  std::vector<double> direction(5 * mesh.vertex_count());
  for (double& d : direction) d = spread(random);
  const std::vector<double> expected = difference(residual, state, direction);
  const auto& plan = residual.plan();
  double worst = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    std::array<double, 5> product{};
    const auto add = [&](std::size_t block, std::uint32_t w) {
      for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t i = 0; i < 5; ++i) product[i] += blocks[25 * block + 5 * j + i] * direction[5 * w + j];
    };
    add(plan.diagonal_block(v), v);
    for (std::uint32_t s = plan.neighbours.offsets()[v]; s < plan.neighbours.offsets()[v + 1]; ++s)
      add(plan.neighbour_block(v, s), plan.neighbours.links()[s]);
    for (std::size_t i = 0; i < 5; ++i) worst = std::max(worst, std::abs(product[i] - expected[5 * v + i]));
  }
  CHECK(worst < 1e-6);
}

TEST_CASE("flow_over_a_bump_in_space_converges_and_is_symmetric") {
  test::start_petsc();
  const auto channel = [](double s, double t, double u) {
    const double x = 3 * s, pi = std::numbers::pi;
    const double floor = x > 1 && x < 2 ? 0.1 * std::pow(std::sin(pi * (x - 1)) * std::sin(pi * t), 2) : 0;
    return Point3{x, t, floor + u * (1 - floor)};
  };
  for (const BoxCells kind : every_kind) {
    const MixedMesh<3> mesh = test::box_grid({18, 6, 6}, kind, channel);
    FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.5}};
    set_all_sides<3>(problem, BoundaryKind::slip_wall);
    problem.boundary[test::low_x] = problem.boundary[test::high_x] = BoundaryKind::far_field;
    const SteadyResult<3> result = solver::solve_steady(problem, {.residual_drop_orders = 10});
    CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
    CHECK(result.history.back().number <= 30);
    CHECK(result.forces_by_marker.at(test::low_z).cl > 0.01);  // the bump lies in the suction of its own making ...
    CHECK(result.forces.cd > 0);                               // ... with an error of the scheme along it
    CHECK(result.forces.cd < 0.02);
    if (kind == BoxCells::hexahedra) CHECK(std::abs(result.forces.cy) < 1e-9);
  }
}

TEST_CASE("supersonic_flow_over_a_wedge_in_space_is_that_of_the_plane") {
  test::start_petsc();
  const auto ramp = [](double s, double, double u) {
    const double x = 1.2 * s, floor = x > 0.2 ? (x - 0.2) * std::tan(10 * std::numbers::pi / 180) : 0;
    return std::array{x, floor + u * (1 - floor)};
  };
  const MixedMesh<3> mesh = test::box_grid({24, 2, 20}, BoxCells::hexahedra, [&](double s, double t, double u) {
    return Point3{ramp(s, t, u)[0], 0.1 * t, ramp(s, t, u)[1]};
  });
  FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {2}};
  set_all_sides<3>(problem, BoundaryKind::symmetry);
  problem.boundary[test::low_x] = BoundaryKind::supersonic_inflow;
  problem.boundary[test::high_x] = problem.boundary[test::high_z] = BoundaryKind::supersonic_outflow;
  const SteadyResult<3> space = solver::solve_steady(problem, {.residual_drop_orders = 10});
  CHECK_MESSAGE(space.verdict == Verdict::converged, space.words);

  const MixedMesh<2> section = test::mixed_grid(
      24, 20, [&](double s, double t) { return Point2{ramp(s, 0, t)[0], ramp(s, 0, t)[1]}; },
      [](std::size_t, std::size_t) { return true; });
  const FlowProblem<2> flat{.dual = mesh::build_dual(section),
                            .free_stream = {2},
                            .boundary = {{test::south, BoundaryKind::symmetry},
                                         {test::east, BoundaryKind::supersonic_outflow},
                                         {test::north, BoundaryKind::supersonic_outflow},
                                         {test::west, BoundaryKind::supersonic_inflow}}};
  const SteadyResult<2> plane = solver::solve_steady(flat, {.residual_drop_orders = 10});
  // The limiter measures lengths by control volumes, so the two agree as limited schemes do: to the second digit at the shock.
  double mean = 0;
  for (const VertexId v : mesh.points.ids()) {
    const std::size_t column = v.index() % 25, row = v.index() / (25 * 3);
    const State<2>& expected = plane.state[VertexId::from(row * 25 + column)];
    mean += std::abs(space.state[v].p - expected.p) + std::abs(space.state[v].w - expected.v);
  }
  CHECK(mean / static_cast<double>(mesh.vertex_count()) < 2e-3);
}

}  // namespace
