// SPDX-License-Identifier: MIT
// Quadrilaterals, whole, alone and beside triangles: what the solver reads is their dual.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/solver/residual.hpp"
#include "leonhard/solver/steady.hpp"
#include "tests/solver/meshes.hpp"
#include "tests/solver/session.hpp"

namespace {

using namespace leonhard;
using solver::FlowResidual;

Point2 shaken(double s, double t) {  // the same for the same corner, whichever cell asks
  const double wave = std::sin(97 * s + 31 * t);
  const bool inside = s > 0 && s < 1 && t > 0 && t < 1;
  return {s + (inside ? 0.012 * wave : 0), t + (inside ? 0.012 * std::cos(53 * s - 71 * t) : 0)};
}

TEST_CASE("free_stream_is_kept_to_rounding_on_quadrilaterals_and_mixtures") {
  const auto all = [](std::size_t, std::size_t) { return true; };
  const auto some = [](std::size_t i, std::size_t j) { return (i * 7 + j * 5) % 3 != 0; };
  for (const auto& whole : {std::function<bool(std::size_t, std::size_t)>(all), {some}}) {
    const MixedMesh<2> mesh = test::mixed_grid(18, 14, shaken, whole);
    FlowProblem<2> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.7, 0.3}, .vortex_correction = false};
    for (const Marker side : {test::south, test::east, test::north, test::west})
      problem.boundary[side] = BoundaryKind::far_field;
    std::vector<double> out;
    FlowResidual<2>(problem, {}).evaluate(
        PerId<VertexId, State<2>>(mesh.vertex_count(), solver::free_stream_state<2>({}, {0.7, 0.3})), out);
    double worst = 0;
    for (std::size_t i = 0; i < 4 * mesh.vertex_count(); ++i) worst = std::max(worst, std::abs(out[i]));
    CHECK(worst < 1e-13);
  }
}

TEST_CASE("boundary_flux_of_quadrilaterals_is_exact_for_linear_fluxes_along_a_wall_of_any_spacing") {
  // Still gas with p = 1 + x: the net force on a control volume at the wall y = 0 is its volume times dp/dx along the wall
  // and nothing across it, if the wall carries p at the vertex.
  const auto stretched = [](double s, double t) { return Point2{s * s + s, t}; };
  const MixedMesh<2> mesh = test::mixed_grid(12, 4, stretched, [](std::size_t, std::size_t) { return true; });
  FlowProblem<2> problem{.dual = mesh::build_dual(mesh), .free_stream = {0.5, 0}, .vortex_correction = false};
  for (const Marker side : {test::south, test::east, test::north, test::west})
    problem.boundary[side] = BoundaryKind::slip_wall;
  PerId<VertexId, State<2>> state;
  for (const Point2 p : mesh.points) state.push_back({1, 0, 0, 1 + p.x});
  std::vector<double> out;
  FlowResidual<2>(problem, {.flux = FluxKind::roe, .limiter = LimiterKind::none}).evaluate(state, out);
  for (const VertexId v : mesh.points.ids()) {
    const Point2 p = mesh.points[v];
    if (p.y > 0 || p.x < 1e-9 || p.x > 2 - 1e-9) continue;
    CHECK(std::abs(out[4 * v.index() + 2]) < 1e-12);  // no force across: p does not change with y
    CHECK(out[4 * v.index() + 1] == doctest::Approx(problem.dual.volume[v]).epsilon(1e-9));  // dp/dx times volume
  }
}

TEST_CASE("wedge_shock_on_quadrilaterals_has_the_exact_pressure_ratio") {
  test::start_petsc();
  const auto ramp = [](double s, double t) {
    const double x = 1.2 * s, floor = x > 0.2 ? (x - 0.2) * std::tan(10 * std::numbers::pi / 180) : 0;
    return Point2{x, floor + t * (1 - floor)};
  };
  const MixedMesh<2> mesh = test::mixed_grid(48, 40, ramp, [](std::size_t, std::size_t) { return true; });
  const FlowProblem<2> problem{.dual = mesh::build_dual(mesh),
                             .free_stream = {2, 0},
                             .boundary = {{test::south, BoundaryKind::slip_wall},
                                          {test::east, BoundaryKind::supersonic_outflow},
                                          {test::north, BoundaryKind::supersonic_outflow},
                                          {test::west, BoundaryKind::supersonic_inflow}}};
  const SteadyResult<2> result = solver::solve_steady(problem, {.residual_drop_orders = 10});
  CHECK_MESSAGE(result.verdict == Verdict::converged, result.words);
  REQUIRE(result.surface.size() == 1);
  for (const SurfacePoint& p : result.surface[0].points)  // Mach 2 turned by 10 degrees: p2/p1 = 1.706579
    if (p.at.x > 0.6 && p.at.x < 1.1) CHECK(result.state[p.vertex].p * 1.4 == doctest::Approx(1.706579).epsilon(0.01));
}

TEST_CASE("a_dual_that_is_none_is_refused") {
  test::start_petsc();
  const MixedMesh<2> mesh = test::mixed_grid(4, 4, shaken, [](std::size_t, std::size_t) { return true; });
  FlowProblem<2> good{.dual = mesh::build_dual(mesh)};
  for (const Marker side : {test::south, test::east, test::north, test::west})
    good.boundary[side] = BoundaryKind::far_field;
  const auto complaint_of = [&](auto break_it) {
    FlowProblem<2> problem = good;
    break_it(problem.dual);
    try {
      (void)solver::solve_steady(problem, {.max_iterations = 1});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(complaint_of([](MeshDual<2>&) {}).empty());
  const auto says = [](const std::string& text, const char* word) { return text.find(word) != std::string::npos; };
  CHECK(says(complaint_of([](MeshDual<2>& d) { d.volume[VertexId{7}] = -1; }), "vertex 7 at ("));
  CHECK(says(complaint_of([](MeshDual<2>& d) { d.face.push_back({}); }), "faces"));
  CHECK(says(complaint_of([](MeshDual<2>& d) { d.edges.ends[EdgeId{3}][1] = VertexId{99}; }), "99"));
  CHECK(says(complaint_of([](MeshDual<2>& d) { d.boundary[0].corners = {VertexId{0}, VertexId{12}}; }), "0-12"));
  CHECK(says(complaint_of([](MeshDual<2>& d) { d = {}; }), "no cells"));
}

}  // namespace
