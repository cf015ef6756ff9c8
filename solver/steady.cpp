// SPDX-License-Identifier: MIT
#include "leonhard/solver/steady.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/solver/march/march.hpp"

namespace leonhard {

namespace solver {
namespace {

SweepLimiter sweep_limiter(LimiterKind kind) {
  switch (kind) {
    case LimiterKind::none:
      return SweepLimiter::none;
    case LimiterKind::venkatakrishnan:
      return SweepLimiter::venkatakrishnan;
    case LimiterKind::barth_jespersen:
      return SweepLimiter::barth_jespersen;
  }
  return SweepLimiter::none;
}

SpatialOptions spatial_options(const SteadyOptions& o) {
  return {o.order, sweep_limiter(o.limiter), o.venkatakrishnan_k, o.entropy_fix, o.threads, o.part_of,
          o.parts};
}

void require(bool good, const char* name, double value, const char* remedy) {
  if (!good) throw InputError(name, "is " + std::to_string(value), remedy);
}

void check_parts(const TriangleMesh& mesh, const SteadyOptions& o) {
  if (o.part_of.empty()) return;
  if (o.part_of.size() != mesh.vertex_count())
    throw InputError("part_of",
                     "has " + std::to_string(o.part_of.size()) + " entries for " +
                         std::to_string(mesh.vertex_count()) + " vertices",
                     "give one part a vertex, or none");
  const auto beyond =
      std::find_if(o.part_of.begin(), o.part_of.end(), [&](std::uint32_t part) { return part >= o.parts; });
  if (beyond != o.part_of.end())
    throw InputError("part_of",
                     "puts vertex " + std::to_string(beyond - o.part_of.begin()) + " into part " +
                         std::to_string(*beyond) + " of " + std::to_string(o.parts),
                     "number the parts from 0 to parts - 1");
}

void check_options(const EulerProblem& problem, const SteadyOptions& o) {
  require(o.order == 1 || o.order == 2, "order", o.order, "give 1 or 2");
  require(std::isfinite(o.venkatakrishnan_k) && o.venkatakrishnan_k >= 0, "venkatakrishnan_k",
          o.venkatakrishnan_k, "give a number from 0");
  require(o.entropy_fix >= 0 && o.entropy_fix <= 1, "entropy_fix", o.entropy_fix,
          "give a fraction from 0 to 1");
  require(!o.cfl_start || (std::isfinite(*o.cfl_start) && *o.cfl_start > 0), "cfl_start",
          o.cfl_start.value_or(0), "give a number above 0");
  require(!o.cfl_max || *o.cfl_max > 0, "cfl_max", o.cfl_max.value_or(0), "give a number above 0");
  require(o.residual_drop_orders > 0, "residual_drop_orders", o.residual_drop_orders,
          "give a number above 0, e.g. 8");
  require(o.settle_tolerance >= 0, "settle_tolerance", o.settle_tolerance, "give a number from 0");
  require(!o.settle_window || *o.settle_window >= 0, "settle_window", o.settle_window.value_or(0),
          "give iterations, or 0 for never");
  require(o.max_iterations >= 0, "max_iterations", o.max_iterations,
          "give a number of iterations, or 0 for the default");
  require(o.threads >= 1, "threads", o.threads, "give at least one thread");
  if (!o.initial.empty() && o.initial.size() != problem.mesh.vertex_count())
    throw InputError("initial",
                     "has " + std::to_string(o.initial.size()) + " states for " +
                         std::to_string(problem.mesh.vertex_count()) + " vertices",
                     "give one state a vertex, or none");
  check_parts(problem.mesh, o);
}

}  // namespace

March::March(const EulerProblem& p, const SteadyOptions& o, ConvergenceMonitor& b, std::stop_token s)
    : problem(p),
      options(o),
      book(b),
      stop(std::move(s)),
      operator_(p, spatial_options(o)),
      state(o.initial.empty()
                ? PerId<VertexId, State>(p.mesh.vertex_count(), free_stream_state(p.gas, p.free_stream))
                : o.initial) {}

std::optional<Verdict> March::start() {
  bad_vertex = find_bad_vertex(problem, state, {});
  if (!bad_vertex) {
    operator_.evaluate(state, residual);
    first_norm = norm = residual_norm(residual, state.size());
    if (!std::isfinite(norm)) bad_vertex = find_bad_vertex(problem, state, residual);
  }
  if (bad_vertex) return Verdict::diverged;
  return record(0);
}

std::optional<Verdict> March::record(int number) {
  const Forces forces = total(wall_forces(problem, state));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  // A start that is the solution already (an empty channel, say) counts as converged: nothing is left to reduce.
  const double drop = norm > 1e-15 * (1 + first_norm) ? std::log10(first_norm / norm) : 99.0;
  const Iteration iteration{number, drop, forces.cl, forces.cd, forces.cm, cfl, linear_iterations, seconds};
  linear_iterations = 0;
  return book.record(iteration);
}

void to_conserved(Gas gas, const PerId<VertexId, State>& state, std::vector<double>& conserved) {
  conserved.resize(4 * state.size());
  for (const VertexId v : state.ids()) {
    const Conserved q = conserved_of(gas, state[v]);
    for (std::size_t i = 0; i < 4; ++i) conserved[4 * v.index() + i] = q[i];
  }
}

bool to_states(Gas gas, const std::vector<double>& conserved, PerId<VertexId, State>& state) {
  bool physical = true;
  state.resize(conserved.size() / 4);
  for (const VertexId v : state.ids()) {
    const double* q = conserved.data() + 4 * v.index();
    state[v] = state_of(gas, {q[0], q[1], q[2], q[3]});
    physical = physical && is_physical(state[v]);
  }
  return physical;
}

SteadyResult solve_steady(const EulerProblem& problem, const SteadyOptions& options,
                          const std::function<void(const Iteration&)>& monitor, std::stop_token stop) {
  check_problem(problem);
  check_options(problem, options);
  const bool implicit = options.marching == Marching::implicit_ptc;
  ConvergenceMonitor book(options, options.settle_window.value_or(implicit ? 40 : 1000),
                          options.max_iterations > 0 ? options.max_iterations : (implicit ? 500 : 50'000),
                          monitor, stop);
  March march(problem, options, book, stop);
  SteadyResult result;
  if (const auto at_once = march.start())
    result.verdict = *at_once;
  else
    result.verdict = implicit ? march_implicit(march) : march_explicit(march);
  result.history = book.take_history();
  result.words = describe(result.verdict, result.history, march.bad_vertex, problem.mesh);
  if (result.verdict == Verdict::diverged) result.bad_vertex = march.bad_vertex;
  result.state = std::move(march.state);
  result.forces_by_marker = wall_forces(problem, result.state);
  result.forces = total(result.forces_by_marker);
  result.surface = surface_lines(problem, result.state);
  result.rejected_steps = march.rejected;
  result.sweep = march.operator_.kernels().name;
  return result;
}

}  // namespace solver
}  // namespace leonhard
