// SPDX-License-Identifier: MIT
#include "leonhard/solver/march/march.hpp"

#include <cmath>
#include <utility>

namespace leonhard::solver {
namespace {

SpatialOptions spatial_options(const SteadyOptions& o) {
  return {o.order, o.flux, o.limiter, o.venkatakrishnan_k, o.entropy_fix, o.threads, o.part_of, o.parts};
}

}  // namespace

March::March(const EulerProblem& p, const SteadyOptions& o, ConvergenceMonitor& b, std::stop_token s)
    : problem(p),
      options(o),
      book(b),
      stop(std::move(s)),
      spatial(p, spatial_options(o)),
      state(o.initial.empty()
                ? PerId<VertexId, State>(p.mesh.vertex_count(), free_stream_state(p.gas, p.free_stream))
                : o.initial) {}

std::optional<Verdict> March::start() {
  bad_vertex = find_bad_vertex(problem, state, {});
  if (!bad_vertex) {
    spatial.evaluate(state, residual);
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

}  // namespace leonhard::solver
