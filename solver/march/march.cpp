// SPDX-License-Identifier: MIT
#include "leonhard/solver/march/march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leonhard::solver {
namespace {

template <int dim>
SpatialOptions spatial_options(const FlowProblem<dim>& problem, const SteadyOptions& o) {
  const LimiterKind limiter = o.limiter.value_or(usual_limiter(problem.free_stream.mach, problem.viscosity.has_value()));
  const double k = limiter == LimiterKind::nishikawa_r3 ? o.r3_k : o.venkatakrishnan_k;
  return {o.order, o.flux, limiter, k, o.entropy_fix, o.threads, o.part_of, o.parts, o.gradient};
}

/// Means over the volume, over those of the free stream: what is watched where there are no forces.
template <int dim>
std::vector<double> mean_energy_and_pressure(const FlowProblem<dim>& problem, const PerId<VertexId, State<dim>>& state) {
  double volume = 0, kinetic = 0, pressure = 0;
  for (const VertexId v : state.ids()) {
    const double share = problem.dual.volume[v];
    volume += share;
    kinetic += share * state[v].rho * dot(velocity(state[v]), velocity(state[v]));
    pressure += share * state[v].p * problem.gas.gamma;
  }
  return {kinetic / (volume * problem.free_stream.mach * problem.free_stream.mach), pressure / volume};
}

template <int dim>
std::vector<double> monitored_quantities(const FlowProblem<dim>& problem, const PerId<VertexId, State<dim>>& state) {
  std::vector<double> values;
  for (const auto& [name, quantity] : problem.monitored) values.push_back(quantity(state));
  const auto has_forces = [](const auto& entry) { return is_wall(entry.second.kind); };
  return values.empty() && std::ranges::none_of(problem.boundary, has_forces) ? mean_energy_and_pressure(problem, state) : values;
}

/// What rounding leaves of a residual norm: some units in the last place of the fluxes about each vertex, which in
/// units of the free stream are about as large as wave speed times length.
double rounding_errors(const std::vector<double>& speed_sums, std::size_t vertex_count) {
  double sum = 0;
  for (std::size_t v = 0; v < vertex_count; ++v) sum += speed_sums[v] * speed_sums[v];
  return 2 * std::numeric_limits<double>::epsilon() * std::sqrt(sum / static_cast<double>(vertex_count));
}

}  // namespace

template <int dim>
March<dim>::March(const FlowProblem<dim>& p, const SteadyOptions& o, ConvergenceMonitor& b, std::stop_token s)
    : problem(p),
      options(o),
      book(b),
      stop(std::move(s)),
      spatial(p, spatial_options(p, o)),
      state(p.initial.empty()
                ? PerId<VertexId, State<dim>>(p.dual.vertex_count(), free_stream_state<dim>(p.gas, p.free_stream))
                : p.initial) {
  spatial.project(state);
}

template <int dim>
std::optional<Verdict> March<dim>::start() {
  std::vector<double> speed_sums;
  bad_vertex = find_bad_vertex<dim>(problem, state, {});
  if (!bad_vertex) {
    spatial.evaluate(state, residual);
    first_norm = norm = residual_norm(residual, state.size(), n);
    spatial.wave_speed_sums(state, speed_sums);
    rounding = rounding_errors(speed_sums, state.size());
    if (!std::isfinite(norm)) bad_vertex = find_bad_vertex(problem, state, residual);
  }
  if (bad_vertex) return Verdict::diverged;
  return record(0);
}

template <int dim>
std::optional<Verdict> March<dim>::record(int number) {
  stresses = spatial.wall_stresses(state);
  const Forces forces = total(wall_forces(problem, state, stresses));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double drop = norm > 0 && first_norm > 0 ? std::log10(first_norm / norm) : 0;
  const Iteration iteration{number, drop, forces.cl, forces.cd, forces.cm, cfl, linear_iterations, seconds, forces.cy,
                            monitored_quantities(problem, state)};
  linear_iterations = 0;
  // A start that is the solution already (an empty channel, say) counts as converged: nothing is left to reduce.
  return book.record(iteration, norm / rounding);
}

template <int dim>
void to_conserved(Gas gas, const PerId<VertexId, State<dim>>& state, std::vector<double>& conserved) {
  constexpr std::size_t n = dim + 2;
  conserved.resize(n * state.size());
  for (const VertexId v : state.ids()) {
    const Conserved<dim> q = conserved_of(gas, state[v]);
    std::copy(q.begin(), q.end(), conserved.begin() + static_cast<std::ptrdiff_t>(n * v.index()));
  }
}

template <int dim>
bool to_states(Gas gas, const std::vector<double>& conserved, PerId<VertexId, State<dim>>& state) {
  bool physical = true;
  state.resize(conserved.size() / (dim + 2));
  for (const VertexId v : state.ids()) {
    state[v] = state_of<dim>(gas, conserved.data() + (dim + 2) * v.index());
    physical = physical && is_physical(state[v]);
  }
  return physical;
}

template struct March<2>;
template struct March<3>;
template void to_conserved(Gas, const PerId<VertexId, State<2>>&, std::vector<double>&);
template void to_conserved(Gas, const PerId<VertexId, State<3>>&, std::vector<double>&);
template bool to_states(Gas, const std::vector<double>&, PerId<VertexId, State<2>>&);
template bool to_states(Gas, const std::vector<double>&, PerId<VertexId, State<3>>&);

}  // namespace leonhard::solver
