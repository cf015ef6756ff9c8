// SPDX-License-Identifier: MIT
#include "leonhard/solver/steady.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/solver/march/march.hpp"
#include "leonhard/solver/periodic.hpp"

namespace leonhard::solver {
namespace {

void require(bool good, const char* name, double value, const char* remedy) {
  if (!good) throw InputError(name, "is " + std::to_string(value), remedy);
}

template <int dim>
void check_parts(const MeshDual<dim>& dual, const SteadyOptions& o) {
  if (o.part_of.empty()) return;
  if (o.part_of.size() != dual.vertex_count())
    throw InputError("part_of",
                     "has " + std::to_string(o.part_of.size()) + " entries for " +
                         std::to_string(dual.vertex_count()) + " vertices",
                     "give one part a vertex, or none");
  const auto beyond =
      std::find_if(o.part_of.begin(), o.part_of.end(), [&](std::uint32_t part) { return part >= o.parts; });
  if (beyond != o.part_of.end())
    throw InputError("part_of",
                     "puts vertex " + std::to_string(beyond - o.part_of.begin()) + " into part " +
                         std::to_string(*beyond) + " of " + std::to_string(o.parts),
                     "number the parts from 0 to parts - 1");
}

template <int dim>
void check_options(const FlowProblem<dim>& problem, const SteadyOptions& o) {
  require(o.order == 1 || o.order == 2, "order", o.order, "give 1 or 2");
  require(std::isfinite(o.venkatakrishnan_k) && o.venkatakrishnan_k >= 0, "venkatakrishnan_k",
          o.venkatakrishnan_k, "give a number from 0");
  require(std::isfinite(o.r3_k) && o.r3_k >= 0, "r3_k", o.r3_k, "give a number from 0");
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
  require(std::isfinite(o.residual_smoothing) && o.residual_smoothing >= 0, "residual_smoothing", o.residual_smoothing,
          "give a number from 0, e.g. 0.6");
  require(o.threads >= 1, "threads", o.threads, "give at least one thread");
  check_parts(problem.dual, o);
}

/// States, stresses, history and verdict; the rest follows from them.
/// problem  without periodic sides
template <int dim>
SteadyResult<dim> march(const FlowProblem<dim>& problem, const SteadyOptions& options,
                        const std::function<void(const Iteration&)>& monitor, const std::stop_token& stop) {
  const bool implicit = options.marching == Marching::implicit_ptc;
  ConvergenceMonitor book(options, options.settle_window.value_or(usual_settle_window(options.marching)),
                          options.max_iterations > 0 ? options.max_iterations : usual_max_iterations(options.marching),
                          monitor, stop);
  March<dim> march(problem, options, book, stop);
  SteadyResult<dim> result;
  if (const auto at_once = march.start())
    result.verdict = *at_once;
  else
    result.verdict = implicit ? march_implicit(march) : march_explicit(march);
  result.at_rounding = book.at_rounding();
  result.history = book.take_history();
  if (result.verdict == Verdict::diverged) result.bad_vertex = march.bad_vertex;
  if (result.verdict != Verdict::diverged && result.verdict != Verdict::converged)
    result.worst = worst_vertices(problem, march.state, march.residual, 10);
  result.mass_flow = march.spatial.mass_flow(march.state);
  result.state = std::move(march.state);
  result.stresses = std::move(march.stresses);
  result.rejected_steps = march.rejected;
  result.sweep = march.spatial.kernels().name;
  return result;
}

}  // namespace

template <int dim>
SteadyResult<dim> solve_steady(const FlowProblem<dim>& problem, const SteadyOptions& options,
                               const std::function<void(const Iteration&)>& monitor, std::stop_token stop) {
  check_problem(problem);
  check_options(problem, options);
  SteadyResult<dim> result;
  if (is_periodic(problem.boundary)) {
    const JoinedProblem<dim> joined = join_periodic(problem);
    SteadyOptions of_joined = options;
    of_joined.part_of.clear();
    if (!options.part_of.empty())
      for (const VertexId first : joined.first_of) of_joined.part_of.push_back(options.part_of[first.index()]);
    result = march(joined.problem, of_joined, monitor, stop);
    spread(problem, joined, result);
  } else {
    result = march(problem, options, monitor, stop);
  }
  result.words = describe(result.verdict, result.at_rounding, result.history, result.bad_vertex, problem.dual) +
                 describe(result.worst, problem.dual);
  result.forces_by_marker = wall_forces(problem, result.state, result.stresses);
  result.forces = total(result.forces_by_marker);
  if constexpr (dim == 2) result.surface = surface_lines(problem, result.state, result.stresses);
  return result;
}

template SteadyResult<2> solve_steady(const FlowProblem<2>&, const SteadyOptions&,
                                      const std::function<void(const Iteration&)>&, std::stop_token);
template SteadyResult<3> solve_steady(const FlowProblem<3>&, const SteadyOptions&,
                                      const std::function<void(const Iteration&)>&, std::stop_token);

}  // namespace leonhard::solver
