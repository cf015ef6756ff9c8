// SPDX-License-Identifier: MIT
#include "leonhard/app/solve/march.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace leonhard::app {
namespace {

/// Seconds until the residual has fallen as asked, from its fall over the last iterations; none if it does not fall.
std::optional<double> seconds_left(const std::vector<Iteration>& recent, double goal) {
  if (recent.size() < 2) return {};
  const double orders = recent.back().residual_drop_orders - recent.front().residual_drop_orders;
  const double seconds = recent.back().seconds - recent.front().seconds;
  if (orders <= 0) return {};
  return std::max(0.0, (goal - recent.back().residual_drop_orders) / orders * seconds);
}

}  // namespace

template <int dim>
std::string march(FlowRun<dim>& run, const FlowProblem<dim>& problem, const SteadyOptions& options, Console& console,
                  std::stop_token stop) {
  std::vector<Iteration> recent;
  const auto monitor = [&](const Iteration& now) {
    if (!console.talks()) return;
    recent.push_back(now);
    if (recent.size() > 20) recent.erase(recent.begin());
    const auto left = seconds_left(recent, options.residual_drop_orders);
    console.transient(
        fmt::format("iteration {:>5}   residual down {:>5.2f} orders   CL {:>8.5f}   CD {:>8.5f}   {}",
                    now.number, now.residual_drop_orders, now.cl, now.cd,
                    left ? fmt::format("{:.0f} s left", std::ceil(*left)) : ""));
  };
  run.flow = solver::solve_steady(problem, options, monitor, std::move(stop));
  const Iteration last = run.flow.history.empty() ? Iteration{} : run.flow.history.back();
  return fmt::format("{}: {} iterations, residual down {:.1f} orders", to_string(run.flow.verdict), last.number,
                     last.residual_drop_orders);
}

template std::string march(FlowRun<2>&, const FlowProblem<2>&, const SteadyOptions&, Console&, std::stop_token);
template std::string march(FlowRun<3>&, const FlowProblem<3>&, const SteadyOptions&, Console&, std::stop_token);

}  // namespace leonhard::app
