// SPDX-License-Identifier: MIT
#include "leonhard/solver/periodic.hpp"

#include <string>
#include <utility>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::solver {
namespace {

template <int dim>
std::string side_name(const MeshDual<dim>& dual, Marker marker) {
  const auto found = dual.marker_names.find(marker);
  return found == dual.marker_names.end() ? "marker " + std::to_string(marker) : "\"" + found->second + "\"";
}

/// The pair that a side and its partner make.
template <int dim>
PeriodicSides<dim> pair_of(const MeshDual<dim>& dual, const std::map<Marker, BoundaryCondition<dim>>& boundary, Marker marker) {
  const BoundaryCondition<dim>& condition = boundary.at(marker);
  const auto partner = boundary.find(condition.partner);
  if (partner == boundary.end() || partner->second.kind != BoundaryKind::periodic || partner->second.partner != marker)
    throw InputError("boundary",
                     side_name(dual, marker) + " is periodic with " + side_name(dual, condition.partner) +
                         ", which is not periodic with it",
                     "make two sides each other's partners");
  if (condition.translation && partner->second.translation)
    throw InputError("boundary",
                     "both " + side_name(dual, marker) + " and its partner " + side_name(dual, condition.partner) +
                         " give a translation",
                     "give it for one of them");
  PeriodicSides<dim> sides{marker, condition.partner, condition.translation};
  if (partner->second.translation) sides.translation = -*partner->second.translation;
  return sides;
}

/// The states of a joined dual for the vertices of the mesh.
template <int dim>
PerId<VertexId, State<dim>> spread_states(const PerId<VertexId, State<dim>>& state, const PerId<VertexId, VertexId>& joined_of) {
  PerId<VertexId, State<dim>> all;
  for (const VertexId standing : joined_of) all.push_back(state[standing]);
  return all;
}

}  // namespace

template <int dim>
std::vector<PeriodicMatch<dim>> match_periodic(const MeshDual<dim>& dual,
                                               const std::map<Marker, BoundaryCondition<dim>>& boundary) {
  std::vector<PeriodicMatch<dim>> matches;
  for (const auto& [marker, condition] : boundary) {
    if (condition.kind != BoundaryKind::periodic) continue;
    const PeriodicSides<dim> sides = pair_of(dual, boundary, marker);
    if (marker <= condition.partner) matches.push_back(mesh::match_sides(dual, sides));
  }
  return matches;
}

template <int dim>
JoinedProblem<dim> join_periodic(const FlowProblem<dim>& problem) {
  const std::vector<PeriodicMatch<dim>> matches = match_periodic(problem.dual, problem.boundary);
  JoinedDual<dim> dual = mesh::join_sides<dim>(problem.dual, matches);
  JoinedProblem<dim> joined{{.dual = std::move(dual.dual),
                             .gas = problem.gas,
                             .free_stream = problem.free_stream,
                             .boundary = problem.boundary,
                             .reference = problem.reference,
                             .vortex_correction = problem.vortex_correction,
                             .vortex_centre = problem.vortex_centre,
                             .outer_state = problem.outer_state,
                             .viscosity = problem.viscosity,
                             .source = problem.source},
                            std::move(dual.joined_of),
                            std::move(dual.first_of)};
  std::erase_if(joined.problem.boundary, [](const auto& entry) { return entry.second.kind == BoundaryKind::periodic; });
  if (!problem.initial.empty())
    for (const VertexId first : joined.first_of) joined.problem.initial.push_back(problem.initial[first]);
  joined.problem.rough_initial = problem.rough_initial;
  for (const auto& [name, quantity] : problem.monitored)
    joined.problem.monitored[name] = [quantity, joined_of = joined.joined_of](const PerId<VertexId, State<dim>>& state) {
      return quantity(spread_states(state, joined_of));
    };
  return joined;
}

template <int dim>
void spread(const FlowProblem<dim>& problem, const JoinedProblem<dim>& joined, SteadyResult<dim>& result) {
  result.state = spread_states(result.state, joined.joined_of);
  std::map<VertexId, WallStress<dim>> stress_at;
  for (WallStress<dim>& stress : result.stresses) stress_at.emplace(stress.at.vertex, std::move(stress));
  result.stresses.clear();
  for (StrongVertex<dim>& at : strong_vertices(problem)) {
    WallStress<dim> stress = stress_at.at(joined.joined_of[at.vertex]);
    stress.at = std::move(at);
    result.stresses.push_back(std::move(stress));
  }
  for (ResidualShare<dim>& share : result.worst) share.vertex = joined.first_of[share.vertex];
  if (result.bad_vertex) result.bad_vertex->vertex = joined.first_of[result.bad_vertex->vertex];
}

#define LEONHARD_PERIODIC(dim)                                                                                       \
  template std::vector<PeriodicMatch<dim>> match_periodic(const MeshDual<dim>&,                                      \
                                                          const std::map<Marker, BoundaryCondition<dim>>&);          \
  template JoinedProblem<dim> join_periodic(const FlowProblem<dim>&);                                                \
  template void spread(const FlowProblem<dim>&, const JoinedProblem<dim>&, SteadyResult<dim>&);
LEONHARD_PERIODIC(2)
LEONHARD_PERIODIC(3)
#undef LEONHARD_PERIODIC

}  // namespace leonhard::solver
