// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <stop_token>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/solver/march/monitor.hpp"
#include "leonhard/solver/residual.hpp"
#include "leonhard/solver/steady.hpp"
#include "tests/solver/meshes.hpp"
#include "tests/solver/session.hpp"

namespace {

using namespace leonhard;

FlowProblem<2> square_problem(const TriangleMesh& mesh) {
  return {mesh::build_dual(mesh),
          {},
          {0.5, 0},
          {{test::south, BoundaryKind::slip_wall},
           {test::east, BoundaryKind::far_field},
           {test::north, BoundaryKind::far_field},
           {test::west, BoundaryKind::far_field}},
          {},
          true,
          {0.25, 0},
          {}};
}

FlowProblem<2> airfoil_problem(const TriangleMesh& mesh) {
  return {mesh::build_dual(mesh),        {},
          {0.8, 0.02}, {{test::south, BoundaryKind::slip_wall}, {test::north, BoundaryKind::far_field}},
          {},          true,
          {0.25, 0},   {}};
}

std::string complaint(const FlowProblem<2>& problem, const SteadyOptions& options = {}) {
  try {
    (void)solver::solve_steady(problem, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("nonsense_state_is_diverged_and_names_the_vertex") {
  test::start_petsc();
  const TriangleMesh mesh = test::shaken_square(6, 0.1, 1);
  FlowProblem<2> problem = square_problem(mesh);
  for (const State<2> nonsense :
       {State<2>{-1, 0.5, 0, 0.7}, State<2>{1, 0.5, 0, std::numeric_limits<double>::quiet_NaN()}}) {
    SteadyOptions options;
    problem.initial = PerId<VertexId, State<2>>(mesh.vertex_count(), solver::free_stream_state<2>({}, {0.5, 0}));
    problem.initial[VertexId::from(9)] = nonsense;
    const SteadyResult<2> result = solver::solve_steady(problem, options);
    CHECK(result.verdict == Verdict::diverged);
    REQUIRE(result.bad_vertex);
    CHECK(result.bad_vertex->vertex == VertexId::from(9));
    CHECK(result.bad_vertex->at == mesh.points[VertexId::from(9)]);
    REQUIRE(result.bad_vertex->nearest_marker);
    CHECK(*result.bad_vertex->nearest_marker == test::south);
    CHECK(says(result.words, "vertex 9"));
    CHECK(says(result.words, "south"));
  }
}

TEST_CASE("explicit_march_with_an_absurd_time_step_cuts_it_and_goes_on") {
  const TriangleMesh mesh = test::o_mesh(48, 16, 8, 0.03, test::naca0012);
  SteadyOptions options;
  options.marching = Marching::explicit_multistage;
  options.cfl_start = 1e4;
  options.max_iterations = 50;
  const SteadyResult<2> result = solver::solve_steady(airfoil_problem(mesh), options);
  CHECK(result.verdict == Verdict::iteration_limit);
  CHECK(result.history.size() == 51);
  CHECK(result.rejected_steps > 0);
  CHECK_FALSE(result.bad_vertex);
  CHECK(result.history.back().cfl < 100);
  for (const State<2>& w : result.state) CHECK(solver::is_physical(w));
}

TEST_CASE("bad_vertex_is_the_first_unphysical_one_or_else_the_first_whose_residual_is_not_finite") {
  const TriangleMesh mesh = test::shaken_square(6, 0.1, 1);
  const FlowProblem<2> problem = square_problem(mesh);
  PerId<VertexId, State<2>> state(mesh.vertex_count(), solver::free_stream_state<2>({}, {0.5, 0}));
  std::vector<double> residual(4 * mesh.vertex_count());
  CHECK_FALSE(solver::find_bad_vertex(problem, state, residual));
  residual[4 * 30 + 3] = std::numeric_limits<double>::infinity();
  residual[4 * 12 + 1] = std::numeric_limits<double>::quiet_NaN();
  const auto by_residual = solver::find_bad_vertex(problem, state, residual);
  REQUIRE(by_residual);
  CHECK(by_residual->vertex == VertexId::from(12));
  state[VertexId::from(20)].p = 0;
  const auto by_state = solver::find_bad_vertex(problem, state, residual);
  REQUIRE(by_state);
  CHECK(by_state->vertex == VertexId::from(20));
  CHECK(by_state->state.p == 0);
}

TEST_CASE("stop_request_ends_the_march_at_once") {
  test::start_petsc();
  const TriangleMesh mesh = test::o_mesh(48, 16, 8, 0.03, test::naca0012);
  for (const Marching marching : {Marching::implicit_ptc, Marching::explicit_multistage}) {
    SteadyOptions options;
    options.marching = marching;
    std::stop_source source;
    int reports = 0;
    const SteadyResult<2> result = solver::solve_steady(
        airfoil_problem(mesh), options,
        [&](const Iteration&) {
          if (++reports == 4) source.request_stop();
        },
        source.get_token());
    CHECK(result.verdict == Verdict::stopped);
    CHECK(reports == 4);
    CHECK(result.history.size() == 4);
    CHECK(result.surface.size() == 1);  // what there is can be written
  }
}

TEST_CASE("iteration_limit_is_a_verdict") {
  test::start_petsc();
  const TriangleMesh mesh = test::o_mesh(32, 10, 8, 0.05, test::naca0012);
  SteadyOptions options;
  options.max_iterations = 3;
  const SteadyResult<2> result = solver::solve_steady(airfoil_problem(mesh), options);
  CHECK(result.verdict == Verdict::iteration_limit);
  CHECK(result.history.size() == 4);
}

TEST_CASE("what_is_left_of_the_residual_is_told_by_its_worst_vertices") {
  test::start_petsc();
  const TriangleMesh mesh = test::shaken_square(12, 0.1, 1);
  FlowProblem<2> problem = square_problem(mesh);
  problem.initial = PerId<VertexId, State<2>>(mesh.vertex_count(), solver::free_stream_state<2>({}, problem.free_stream));
  const VertexId disturbed = VertexId::from(60);
  problem.initial[disturbed].p *= 1.2;
  SteadyOptions options;
  options.marching = Marching::explicit_multistage;
  options.cfl_start = 1e-3;
  options.max_iterations = 1;
  const SteadyResult<2> result = solver::solve_steady(problem, options);
  CHECK(result.verdict == Verdict::iteration_limit);
  REQUIRE(result.worst.size() == 10);
  std::vector<double> residual;
  solver::FlowResidual<2>(problem, {}).evaluate(result.state, residual);
  const auto square = [&](std::size_t v) {
    double sum = 0;
    for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) sum += residual[i] * residual[i];
    return sum;
  };
  double sum = 0, largest = 0;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) sum += square(v), largest = std::max(largest, square(v));
  CHECK(square(result.worst[0].vertex.index()) == largest);
  for (std::size_t k = 0; k < 10; ++k) {
    CHECK(result.worst[k].share == doctest::Approx(square(result.worst[k].vertex.index()) / sum));
    if (k > 0) CHECK(result.worst[k].share <= result.worst[k - 1].share);
    CHECK(distance(result.worst[k].at, mesh.points[disturbed]) < 0.3);
  }
  CHECK(says(result.words, "first vertex " + std::to_string(result.worst[0].vertex.raw)));
}

TEST_CASE("a_solution_at_the_start_is_converged_at_once") {
  test::start_petsc();
  const TriangleMesh mesh = test::shaken_square(6, 0.2, 1);
  FlowProblem<2> problem = square_problem(mesh);
  problem.boundary[test::south] = BoundaryKind::far_field;
  const SteadyResult<2> result = solver::solve_steady(problem);
  CHECK(result.verdict == Verdict::converged);
  CHECK(result.history.size() == 1);
}

std::optional<Verdict> fed_with(const SteadyOptions& options, const std::function<Iteration(int)>& make,
                                int count) {
  solver::ConvergenceMonitor book(options, 20, 1000, {}, {});
  for (int i = 0; i < count; ++i)
    if (const auto verdict = book.record(make(i))) return verdict;
  return std::nullopt;
}

TEST_CASE("hanging_residual_with_steady_coefficients_is_settled_and_with_moving_ones_stalled") {
  const SteadyOptions options;
  const auto line = [](int i, double drop, double cl) {
    return Iteration{i, drop, cl, 0.02, -0.03, 10, 5, 0.0};
  };
  CHECK(fed_with(
            options, [&](int i) { return line(i, 3 + 0.01 * (i % 2), 0.3 + 1e-8 * (i % 3)); }, 500) ==
        Verdict::settled);
  CHECK(fed_with(
            options, [&](int i) { return line(i, 3 + 0.01 * (i % 2), 0.3 + 1e-3 * (i % 3)); }, 500) ==
        Verdict::stalled);
  CHECK(fed_with(
            options, [&](int i) { return line(i, 0.02 * i, 0.3); }, 300) == std::nullopt);  // still falling
  CHECK(fed_with(
            options, [&](int i) { return line(i, 0.02 * i, 0.3); }, 500) == Verdict::converged);
}

TEST_CASE("a_monitored_quantity_that_moves_keeps_a_hanging_march_from_being_settled") {
  const auto line = [](int i, double quantity) {
    Iteration iteration{i, 3 + 0.01 * (i % 2), 0.3, 0.02, -0.03, 10, 5, 0.0};
    iteration.monitored = {7, quantity};
    return iteration;
  };
  CHECK(fed_with({}, [&](int i) { return line(i, 1e3 + 1e-4 * (i % 3)); }, 500) == Verdict::settled);
  CHECK(fed_with({}, [&](int i) { return line(i, 1e3 + 0.1 * (i % 3)); }, 500) == Verdict::stalled);
}

TEST_CASE("where_there_is_no_wall_energy_and_pressure_are_watched_and_else_what_the_problem_names") {
  test::start_petsc();
  const TriangleMesh mesh = test::shaken_square(6, 0.1, 1);
  FlowProblem<2> problem = square_problem(mesh);
  SteadyOptions options;
  options.max_iterations = 2;
  CHECK(solver::solve_steady(problem, options).history.back().monitored.empty());
  problem.boundary[test::south] = BoundaryKind::symmetry;
  const auto watched = solver::solve_steady(problem, options).history.front().monitored;
  REQUIRE(watched.size() == 2);
  CHECK(watched[0] == doctest::Approx(1));
  CHECK(watched[1] == doctest::Approx(1));
  problem.monitored["seventh"] = [](const PerId<VertexId, State<2>>& state) { return state[VertexId::from(7)].u; };
  CHECK(solver::solve_steady(problem, options).history.front().monitored == std::vector<double>{0.5});
}

TEST_CASE("a_residual_down_to_its_rounding_errors_is_converged_and_says_so") {
  test::start_petsc();
  const TriangleMesh mesh = test::o_mesh(48, 16, 8, 0.03, test::naca0012);
  FlowProblem<2> problem = airfoil_problem(mesh);
  for (const double mach : {0.8, 0.3, 0.01}) {
    problem.free_stream.mach = mach;
    SteadyOptions options;
    options.residual_drop_orders = 16;
    const SteadyResult<2> result = solver::solve_steady(problem, options);
    CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
    CHECK(result.at_rounding);
    CHECK(says(result.words, "to its rounding errors"));
    options.residual_drop_orders = 3;
    const SteadyResult<2> early = solver::solve_steady(problem, options);
    CHECK_FALSE(early.at_rounding);
    CHECK_FALSE(says(early.words, "rounding"));
  }
}

TEST_CASE("a_first_time_step_however_small_grows") {
  test::start_petsc();
  const TriangleMesh mesh = test::o_mesh(48, 16, 8, 0.03, test::naca0012);
  SteadyOptions options;
  options.cfl_start = 1e-6;
  const SteadyResult<2> result = solver::solve_steady(airfoil_problem(mesh), options);
  CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
}

TEST_CASE("what_flows_out_through_the_boundaries_adds_up_to_nothing_and_nothing_through_a_wall") {
  test::start_petsc();
  const TriangleMesh mesh = test::o_mesh(48, 16, 8, 0.03, test::naca0012);
  const SteadyResult<2> result = solver::solve_steady(airfoil_problem(mesh));
  REQUIRE(result.mass_flow.size() == 2);
  CHECK(result.mass_flow.at(test::south) == 0);
  CHECK(std::abs(result.mass_flow.at(test::north)) < 1e-8);

  const TriangleMesh square = test::shaken_square(8, 0.2, 1);
  FlowProblem<2> problem = square_problem(square);
  problem.boundary[test::north] = BoundaryKind::slip_wall;
  const SteadyResult<2> duct = solver::solve_steady(problem);
  CHECK(duct.mass_flow.at(test::east) == doctest::Approx(0.5));
  CHECK(duct.mass_flow.at(test::west) == doctest::Approx(-0.5));
}

TEST_CASE("smoothing_keeps_even_steps_spreads_a_peak_and_leaves_no_slip_walls_alone") {
  const TriangleMesh mesh = test::shaken_square(8, 0.2, 1);
  FlowProblem<2> problem = square_problem(mesh);
  problem.viscosity = Viscosity{};
  problem.boundary[test::south] = BoundaryKind::no_slip_wall;
  solver::FlowResidual<2> spatial(problem, {});
  std::vector<double> even(4 * mesh.vertex_count(), 3.0);
  spatial.smooth(0.5, even);
  for (const double step : even) CHECK(step == doctest::Approx(3).epsilon(1e-14));
  // Vertex 40 is in the middle of the square, 4 in that of the wall.
  std::vector<double> peak(4 * mesh.vertex_count(), 0.0);
  peak[4 * 40] = peak[4 * 4 + 2] = 1;
  spatial.smooth(0.5, peak);
  CHECK(peak[4 * 40] > 0.2);
  CHECK(peak[4 * 40] < 0.6);
  CHECK(peak[4 * 41] > 0.02);
  CHECK(peak[4 * 40 + 1] == 0);
  CHECK(peak[4 * 4 + 2] == 1);
  CHECK(peak[4 * 3 + 2] == 0);
  CHECK(peak[4 * 13 + 2] > 0.02);
}

TEST_CASE("marker_without_a_condition_and_condition_without_a_marker_are_refused_by_name") {
  const TriangleMesh mesh = test::shaken_square(4, 0.1, 1);
  FlowProblem<2> problem = square_problem(mesh);
  problem.boundary.erase(test::east);
  CHECK(says(complaint(problem), "east"));
  FlowProblem<2> other = square_problem(mesh);
  other.boundary[77] = BoundaryKind::slip_wall;
  CHECK(says(complaint(other), "77"));
}

TEST_CASE("numbers_out_of_range_are_refused_by_name") {
  const TriangleMesh mesh = test::shaken_square(4, 0.1, 1);
  const FlowProblem<2> good = square_problem(mesh);
  const auto with_mach = [&](double mach) {
    FlowProblem<2> problem = good;
    problem.free_stream.mach = mach;
    return complaint(problem);
  };
  CHECK(says(with_mach(-0.8), "mach"));
  CHECK(says(with_mach(0), "mach"));
  CHECK(says(with_mach(std::numeric_limits<double>::quiet_NaN()), "mach"));
  FlowProblem<2> problem = good;
  problem.gas.gamma = 1;
  CHECK(says(complaint(problem), "gamma"));
  SteadyOptions options;
  options.threads = 0;
  CHECK(says(complaint(good, options), "threads"));
  options = {};
  options.order = 3;
  CHECK(says(complaint(good, options), "order"));
  options = {};
  options.cfl_start = -1;
  CHECK(says(complaint(good, options), "cfl_start"));
  problem = good;
  problem.initial.push_back({1, 0, 0, 1});
  CHECK(says(complaint(problem), "initial"));
  options = {};
  options.parts = 2;
  options.part_of.assign(3, 0);
  CHECK(says(complaint(good, options), "has 3 entries"));
  options.part_of.assign(mesh.vertex_count(), 1);
  options.part_of[4] = 2;
  CHECK(says(complaint(good, options), "puts vertex 4 into part 2 of 2"));
}

}  // namespace
