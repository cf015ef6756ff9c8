// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string>

#include "leonhard/app/console.hpp"
#include "leonhard/app/solve/run.hpp"

namespace leonhard::app {

/// March to a steady state, a line an iteration on the console; the result goes into the run.
/// returns  one line about it
template <int dim>
std::string march(FlowRun<dim>& run, const FlowProblem<dim>& problem, const SteadyOptions& options, Console& console,
                  std::stop_token stop);

}  // namespace leonhard::app
