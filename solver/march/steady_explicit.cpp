// SPDX-License-Identifier: MIT
#include "leonhard/solver/march/march.hpp"

#include <algorithm>
#include <cmath>

namespace leonhard::solver {
namespace {

// Three stages for second-order upwind differences: B. van Leer, C.-H. Tai and K. G. Powell, AIAA 89-1933, table 1.
constexpr double stage_share[3] = {0.1918, 0.4929, 1.0};
constexpr double default_cfl = 2.5;
constexpr double least_cfl = 1e-3;  ///< or this share of the first one

/// One iteration from `before`; the last stage's state is left in march.state.
/// returns  whether all stages were physical
template <int dim>
bool three_stages(March<dim>& march, const std::vector<double>& before, const std::vector<double>& speeds,
                  std::vector<double>& step, std::vector<double>& now) {
  now.resize(before.size()), step.resize(before.size());
  for (int stage = 0; stage < 3; ++stage) {
    if (stage > 0) march.spatial.evaluate(march.state, march.residual);
    const double share = stage_share[stage] * march.cfl;
    for (std::size_t v = 0; v < march.state.size(); ++v)
      for (std::size_t i = march.n * v; i < march.n * (v + 1); ++i) step[i] = share / speeds[v] * march.residual[i];
    if (march.options.residual_smoothing > 0) march.spatial.smooth(march.options.residual_smoothing, step);
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = before[i] - step[i];
    if (!to_states(march.problem.gas, now, march.state)) return false;
  }
  return true;
}

}  // namespace

template <int dim>
Verdict march_explicit(March<dim>& march) {
  const SteadyOptions& options = march.options;
  march.cfl = std::min(options.cfl_start.value_or(default_cfl), options.cfl_max.value_or(1e300));
  const double least = least_cfl * std::min(march.cfl, 1.0);
  std::vector<double> before, now, speeds, step;
  to_conserved(march.problem.gas, march.state, before);
  for (int number = 1;; ++number) {
    march.spatial.wave_speed_sums(march.state, speeds);
    while (!three_stages(march, before, speeds, step, now)) {
      ++march.rejected;
      march.bad_vertex = find_bad_vertex<dim>(march.problem, march.state, {});
      march.cfl *= 0.5;
      (void)to_states(march.problem.gas, before, march.state);
      march.spatial.evaluate(march.state, march.residual);
      if (march.cfl < least) return Verdict::diverged;
      if (march.stop.stop_requested()) return Verdict::stopped;
    }
    march.spatial.evaluate(march.state, march.residual);
    march.norm = residual_norm(march.residual, march.state.size(), march.n);
    before.swap(now);
    if (!std::isfinite(march.norm)) {
      march.bad_vertex = find_bad_vertex(march.problem, march.state, march.residual);
      return Verdict::diverged;
    }
    if (const auto verdict = march.record(number)) return *verdict;
  }
}

template Verdict march_explicit(March<2>&);
template Verdict march_explicit(March<3>&);

}  // namespace leonhard::solver
