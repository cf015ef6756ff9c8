// SPDX-License-Identifier: MIT
#include "leonhard/solver/march/march.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace leonhard::solver {
namespace {

SpatialOptions spatial_options(const SteadyOptions& o) {
  return {o.order, o.flux, o.limiter, o.venkatakrishnan_k, o.entropy_fix, o.threads, o.part_of, o.parts};
}

/// What rounding leaves of a residual norm: some units in the last place of the fluxes about each vertex, which in
/// units of the free stream are about as large as wave speed times length.
double rounding_errors(const std::vector<double>& speed_sums, std::size_t vertex_count) {
  double sum = 0;
  for (std::size_t v = 0; v < vertex_count; ++v) sum += speed_sums[v] * speed_sums[v];
  return 2 * std::numeric_limits<double>::epsilon() * std::sqrt(sum / static_cast<double>(vertex_count));
}

}  // namespace

March::March(const EulerProblem& p, const SteadyOptions& o, ConvergenceMonitor& b, std::stop_token s)
    : problem(p),
      options(o),
      book(b),
      stop(std::move(s)),
      spatial(p, spatial_options(o)),
      state(o.initial.empty()
                ? PerId<VertexId, State>(p.dual.vertex_count(), free_stream_state(p.gas, p.free_stream))
                : o.initial) {}

std::optional<Verdict> March::start() {
  std::vector<double> speed_sums;
  bad_vertex = find_bad_vertex(problem, state, {});
  if (!bad_vertex) {
    spatial.evaluate(state, residual);
    first_norm = norm = residual_norm(residual, state.size());
    spatial.wave_speed_sums(state, speed_sums);
    rounding = rounding_errors(speed_sums, state.size());
    if (!std::isfinite(norm)) bad_vertex = find_bad_vertex(problem, state, residual);
  }
  if (bad_vertex) return Verdict::diverged;
  return record(0);
}

std::optional<Verdict> March::record(int number) {
  const Forces forces = total(wall_forces(problem, state));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double drop = norm > 0 && first_norm > 0 ? std::log10(first_norm / norm) : 0;
  const Iteration iteration{number, drop, forces.cl, forces.cd, forces.cm, cfl, linear_iterations, seconds};
  linear_iterations = 0;
  // A start that is the solution already (an empty channel, say) counts as converged: nothing is left to reduce.
  return book.record(iteration, norm <= rounding);
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

}  // namespace leonhard::solver
