// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "leonhard/mesh/periodic.hpp"
#include "leonhard/solver/problem.hpp"
#include "leonhard/solver/steady_result.hpp"

// A flow with periodic sides is marched on a dual in which paired vertices are one (mesh::join_sides).

namespace leonhard::solver {

/// The pairs of all periodic sides, each pair once, in the order of the markers; none where there are none.
/// throws  InputError naming markers: a partner that is not periodic or has another partner, a translation given by both sides;
///         and as mesh::match_sides
template <int dim>
[[nodiscard]] std::vector<PeriodicMatch<dim>> match_periodic(const MeshDual<dim>& dual,
                                                             const std::map<Marker, BoundaryCondition<dim>>& boundary);

/// A problem whose periodic sides are joined.
template <int dim>
struct JoinedProblem {
  FlowProblem<dim> problem;              ///< has no periodic sides
  PerId<VertexId, VertexId> joined_of;   ///< see JoinedDual
  PerId<VertexId, VertexId> first_of;    ///< likewise
};

[[nodiscard]] inline bool is_periodic(const auto& boundary) {
  for (const auto& [marker, condition] : boundary)
    if (condition.kind == BoundaryKind::periodic) return true;
  return false;
}

/// problem  checked (check_problem). Of initial states, those of the first vertices count.
template <int dim>
[[nodiscard]] JoinedProblem<dim> join_periodic(const FlowProblem<dim>& problem);

/// What was found on the joined dual, for the vertices of the mesh: states, stresses, and the numbers of single vertices.
template <int dim>
void spread(const FlowProblem<dim>& problem, const JoinedProblem<dim>& joined, SteadyResult<dim>& result);

}  // namespace leonhard::solver
