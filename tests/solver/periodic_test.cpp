// SPDX-License-Identifier: MIT
// Sides joined by a translation: the scheme on a joined dual against the same mesh laid side by side, and exact flows.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/mesh/periodic.hpp"
#include "leonhard/solver/periodic.hpp"
#include "leonhard/solver/residual.hpp"
#include "leonhard/solver/steady.hpp"
#include "tests/solver/boxes.hpp"
#include "tests/solver/meshes.hpp"
#include "tests/solver/session.hpp"

namespace {

using namespace leonhard;

constexpr double turn = 2 * std::numbers::pi;

template <int dim>
BoundaryCondition<dim> with_partner(Marker partner) {
  BoundaryCondition<dim> condition = BoundaryKind::periodic;
  condition.partner = partner;
  return condition;
}

/// A strip `copies` long and 1 high whose inner points, and those of both ends alike, are moved about with period 1.
Point2 wavy(double x, double y) {
  const double inside = y > 0 && y < 1 ? 0.07 : 0;
  return {x + inside * std::sin(turn * (x + 2 * y)), y + inside * std::cos(turn * (2 * x + y))};
}

/// The unit cube with all its points moved about, those of opposite sides alike.
Point3 shaken_torus(double s, double t, double u) {
  return {s + 0.02 * std::sin(turn * (s + 2 * t + u)), t + 0.02 * std::cos(turn * (2 * s + t)), u + 0.02 * std::sin(turn * (t - u))};
}

State<2> wave(Point2 p) {
  return {1 + 0.1 * std::sin(turn * p.x + p.y), 0.5 + 0.1 * std::cos(turn * p.x), 0.1 * std::sin(turn * p.x + 2 * p.y),
          (1 + 0.1 * std::cos(turn * p.x - p.y)) / 1.4};
}

FlowProblem<2> strip(std::size_t columns, std::size_t copies, bool periodic) {
  const MixedMesh<2> mesh = test::mixed_grid(
      columns * copies, 5, [&](double s, double t) { return wavy(static_cast<double>(copies) * s, t); },
      [](std::size_t, std::size_t j) { return j == 2; });
  FlowProblem<2> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.5}};
  problem.viscosity = Viscosity{.reynolds = 100};
  problem.boundary = {{test::south, BoundaryKind::far_field}, {test::north, BoundaryKind::slip_wall}};
  if (periodic)
    problem.boundary[test::east] = with_partner<2>(test::west), problem.boundary[test::west] = with_partner<2>(test::east);
  else
    problem.boundary[test::east] = problem.boundary[test::west] = BoundaryKind::far_field;
  problem.vortex_correction = false;
  return problem;
}

PerId<VertexId, State<2>> wave_on(const MeshDual<2>& dual) {
  PerId<VertexId, State<2>> states;
  for (const Point2 p : dual.points) states.push_back(wave(p));
  return states;
}

/// The product of a row of blocks and a vector that has `of(w)` at vertex w.
std::array<double, 4> row_times(const solver::EdgePlan<2>& plan, const std::vector<double>& blocks, std::uint32_t v,
                                const auto& of) {
  std::array<double, 4> sum{};
  const auto add = [&](std::uint32_t w) {
    const std::array<double, 4> x = of(w);
    const double* block = blocks.data() + 16 * plan.block_of(v, w);
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i) sum[i] += block[4 * j + i] * x[j];
  };
  add(v);
  for (const std::uint32_t w : plan.neighbours[v]) add(w);
  return sum;
}

TEST_CASE("a_periodic_strip_is_the_middle_of_seven_however_few_cells_it_has_across") {
  for (const std::size_t columns : {1, 2, 3, 6}) {
    CAPTURE(columns);
    const FlowProblem<2> whole = strip(columns, 7, false), one = strip(columns, 1, true);
    const solver::JoinedProblem<2> joined = solver::join_periodic(one);
    CHECK(joined.problem.dual.vertex_count() == 6 * columns);
    solver::SpatialOptions options;
    // A column alone has no variation along the strip, and this limiter makes kinks of what rounding leaves of it.
    options.limiter = columns > 1 ? LimiterKind::barth_jespersen : LimiterKind::none;
    solver::FlowResidual<2> of_whole(whole, options), of_one(joined.problem, options);
    std::vector<double> long_residual, residual;
    of_whole.evaluate(wave_on(whole.dual), long_residual);
    of_one.evaluate(wave_on(joined.problem.dual), residual);
    std::vector<double> long_blocks(16 * of_whole.plan().block_count()), blocks(16 * of_one.plan().block_count());
    of_whole.jacobian(wave_on(whole.dual), long_blocks);
    of_one.jacobian(wave_on(joined.problem.dual), blocks);
    const std::size_t per_row = 7 * columns + 1;
    const auto vector_at = [](Point2 p) {
      return std::array{std::sin(turn * p.x), std::cos(turn * p.x + p.y), 0.3 * p.y, std::sin(turn * p.x - p.y)};
    };
    double worst = 0, largest = 0, worst_row = 0;
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        const auto long_v = static_cast<std::uint32_t>(j * per_row + 3 * columns + i);
        const auto v = static_cast<std::uint32_t>(joined.joined_of[VertexId::from(j * (columns + 1) + i)].index());
        const auto long_row = row_times(of_whole.plan(), long_blocks, long_v,
                                        [&](std::uint32_t w) { return vector_at(whole.dual.points[VertexId::from(w)]); });
        const auto row = row_times(of_one.plan(), blocks, v,
                                   [&](std::uint32_t w) { return vector_at(joined.problem.dual.points[VertexId::from(w)]); });
        for (std::size_t k = 0; k < 4; ++k) {
          worst = std::max(worst, std::abs(long_residual[4 * long_v + k] - residual[4 * v + k]));
          largest = std::max(largest, std::abs(residual[4 * v + k]));
          worst_row = std::max(worst_row, std::abs(long_row[k] - row[k]));
        }
      }
    CHECK(largest > 1e-3);
    CHECK(worst < 1e-13);
    CHECK(worst_row < 1e-13);
  }
}

TEST_CASE("a_box_periodic_every_way_keeps_the_free_stream_on_every_kind_of_cell_one_cell_thin_too") {
  for (const test::BoxCells kind : {test::BoxCells::tetrahedra, test::BoxCells::hexahedra, test::BoxCells::prisms})
    for (const std::size_t thick : {1, 2, 4}) {
      CAPTURE(thick);
      const MixedMesh<3> mesh = test::box_grid({4, thick, 3}, kind, [](double s, double t, double u) {
        return shaken_torus(s, t, u);
      });
      FlowProblem<3> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.7, 0.3, 0.2}};
      problem.viscosity = Viscosity{.reynolds = 100};
      for (const Marker m : {test::low_x, test::low_y, test::low_z}) {
        problem.boundary[m] = with_partner<3>(m + 1);
        problem.boundary[m + 1] = with_partner<3>(m);
      }
      const solver::JoinedProblem<3> joined = solver::join_periodic(problem);
      CHECK(joined.problem.dual.vertex_count() == 4 * thick * 3);
      CHECK(joined.problem.dual.boundary.empty());
      double volume = 0;
      for (const double v : joined.problem.dual.volume) volume += v;
      CHECK(volume == doctest::Approx(1).epsilon(1e-13));
      solver::FlowResidual<3> spatial(joined.problem, {});
      std::vector<double> residual;
      const PerId<VertexId, State<3>> still(joined.problem.dual.vertex_count(),
                                            solver::free_stream_state<3>(problem.gas, problem.free_stream));
      spatial.evaluate(still, residual);
      double worst = 0;
      for (std::size_t i = 0; i < 5 * still.size(); ++i) worst = std::max(worst, std::abs(residual[i]));
      CHECK(worst < 1e-13);
    }
}

TEST_CASE("a_force_along_a_periodic_channel_drives_poiseuilles_flow") {
  test::start_petsc();
  const double mach = 0.3, reynolds = 50, viscosity = mach / reynolds, force = 8 * viscosity * mach;
  const MixedMesh<2> mesh = test::mixed_grid(
      4, 24, [](double s, double t) { return Point2{0.5 * s, t}; }, [](std::size_t, std::size_t) { return true; });
  FlowProblem<2> problem{.dual = mesh::build_dual(mesh), .free_stream = {mach}};
  problem.viscosity = Viscosity{reynolds, 0.72, -1};
  const auto exact = [&](double y) { return 4 * mach * y * (1 - y); };
  problem.source = [&](Point2 p) { return std::array{0.0, force, 0.0, force * exact(p.y)}; };
  BoundaryCondition<2> wall = BoundaryKind::no_slip_wall;
  wall.temperature = 1.0;
  problem.boundary = {{test::south, wall}, {test::north, wall}, {test::west, with_partner<2>(test::east)},
                      {test::east, with_partner<2>(test::west)}};
  problem.boundary[test::west].translation = Vec2{0.5, 0};
  const SteadyResult<2> result = solver::solve_steady(problem, {.limiter = LimiterKind::none});
  CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
  REQUIRE(result.state.size() == mesh.vertex_count());
  double worst = 0;
  for (const VertexId v : mesh.points.ids()) worst = std::max(worst, std::abs(result.state[v].u - exact(mesh.points[v].y)));
  CHECK(worst < 2e-3 * mach);
  // The walls take the force up: 8 / Re on each, at all their vertices, those of both ends alike.
  CHECK(result.stresses.size() == 10);
  for (const auto& stress : result.stresses) CHECK(stress.friction[0] == doctest::Approx(8 / reynolds).epsilon(5e-3));
  CHECK(result.forces.cd == doctest::Approx(2 * 0.5 * 8 / reynolds).epsilon(5e-3));
  REQUIRE(result.surface.size() == 2);
  for (const SurfaceLine& line : result.surface) {
    CHECK_FALSE(line.closed);
    CHECK(line.points.back().arc_length == doctest::Approx(0.5));
  }
}

/// What match_sides says of the unit square's east and west sides, whose vertices lie at these heights.
std::string refusal(std::size_t rows_west, double lift_east, std::optional<Vec2> translation = {}) {
  // Two strips one above the other would do; a square whose east side is bent or shifted is simpler.
  const TriangleMesh mesh = test::mapped_grid(3, rows_west, false, [&](double s, double t) {
    return Point2{s, t + (s == 1 && t > 0.3 && t < 0.7 ? lift_east : 0)};
  });
  try {
    (void)mesh::match_sides(mesh::build_dual(mesh), PeriodicSides<2>{test::west, test::east, translation});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("sides_that_do_not_match_are_refused_with_the_vertices_that_are_left_over") {
  CHECK(refusal(4, 0) == "");
  CHECK(refusal(4, 1e-9) == "");
  const std::string bent = refusal(4, 1e-3);
  CAPTURE(bent);
  CHECK(bent.find("\"west\" and \"east\"") != std::string::npos);
  CHECK(bent.find("8 at (0, 0.5)") != std::string::npos);
  CHECK(bent.find("11 at (1, 0.501)") != std::string::npos);
  CHECK(bent.find("1 of \"east\"") != std::string::npos);
  const std::string shifted = refusal(4, 0, Vec2{1, 0.25});
  CAPTURE(shifted);
  CHECK(shifted.find("translation (1, 0.25)") != std::string::npos);
  CHECK(shifted.find("16 at (0, 1)") != std::string::npos);

  const auto problem_with = [](const BoundaryCondition<2>& west, const BoundaryCondition<2>& east, Marker other) {
    FlowProblem<2> problem{.dual = mesh::build_dual(test::mapped_grid(4, 4, false, [](double s, double t) { return Point2{s, t}; }))};
    problem.boundary = {{test::south, BoundaryKind::slip_wall}, {test::north, BoundaryKind::slip_wall}};
    problem.boundary[test::west] = west, problem.boundary[other] = east;
    if (other != test::east) problem.boundary[test::east] = BoundaryKind::slip_wall;
    return problem;
  };
  CHECK_NOTHROW(solver::check_problem(problem_with(with_partner<2>(test::east), with_partner<2>(test::west), test::east)));
  CHECK_THROWS_WITH_AS(solver::check_problem(problem_with(with_partner<2>(test::east), BoundaryKind::far_field, test::east)),
                       doctest::Contains("which is not periodic with it"), InputError);
  CHECK_THROWS_WITH_AS(solver::check_problem(problem_with(with_partner<2>(test::west), BoundaryKind::far_field, test::east)),
                       doctest::Contains("are the same"), InputError);
  CHECK_THROWS_WITH_AS(solver::check_problem(problem_with(with_partner<2>(test::south), with_partner<2>(test::west), test::south)),
                       doctest::Contains("share 1 vertices"), InputError);
  BoundaryCondition<2> there = with_partner<2>(test::east), back = with_partner<2>(test::west);
  there.translation = Vec2{1, 0}, back.translation = Vec2{-1, 0};
  CHECK_THROWS_WITH_AS(solver::check_problem(problem_with(there, back, test::east)), doctest::Contains("give it for one"), InputError);
}

}  // namespace
