// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stop_token>

#include "leonhard/solver/problem.hpp"
#include "leonhard/solver/steady_options.hpp"
#include "leonhard/solver/steady_result.hpp"

namespace leonhard::solver {

/// March the Euler or Navier-Stokes equations to a steady state.
///
/// problem  mesh, gas and boundary conditions. Any numbering of the vertices is right; reverse Cuthill-McKee is fastest
/// options  see SteadyOptions
/// monitor  called after each iteration, from this thread; may be empty
/// stop     asked at each iteration and inside linear solves; obeyed within 0.1 s on meshes up to some 10^6 vertices
/// returns  state, forces and a verdict; never throws for a flow that does not converge
/// throws   InputError for a bad problem or option, before any work; what `monitor` throws passes through
/// Implicit marching needs a PetscSession alive (linear_solver.hpp).
template <int dim>
[[nodiscard]] SteadyResult<dim> solve_steady(const FlowProblem<dim>& problem, const SteadyOptions& options = {},
                                             const std::function<void(const Iteration&)>& monitor = {},
                                             std::stop_token stop = {});

}  // namespace leonhard::solver
