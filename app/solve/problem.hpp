// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "leonhard/app/case/case.hpp"
#include "leonhard/solver/problem.hpp"
#include "leonhard/solver/steady_options.hpp"

namespace leonhard::app {

/// The flow that a case asks for.
///
/// conditions  match_conditions of the markers on the dual's boundary
/// dual        in the numbering of the solver
/// throws      InputError where the field that [initial] names is not one of this mesh
template <int dim>
[[nodiscard]] FlowProblem<dim> problem_of(const Case&, const std::map<Marker, BoundaryCase>& conditions,
                                          MeshDual<dim> dual);

/// Whether the periodic sides of a case match on its mesh, in words; "" where there are none.
///
/// dual    of the whole mesh, in the numbering of its file
/// throws  InputError as solver::match_periodic
template <int dim>
[[nodiscard]] std::string match_periodic(const Case&, const std::map<Marker, BoundaryCase>& conditions, const MeshDual<dim>& dual);

/// How the case marches. Parts are left to the solver.
[[nodiscard]] SteadyOptions options_of(const Case&, int threads);

}  // namespace leonhard::app
