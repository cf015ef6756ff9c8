// SPDX-License-Identifier: MIT
#include "leonhard/app/solve/problem.hpp"

#include <fmt/core.h>

#include <numbers>
#include <utility>

#include "leonhard/app/console.hpp"
#include "leonhard/app/solve/initial_field.hpp"
#include "leonhard/solver/periodic.hpp"

namespace leonhard::app {
namespace {

constexpr double sutherland_kelvin = 110.4;  // air

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

template <int dim>
typename Simplex<dim>::Vector vector_of(const std::vector<double>& numbers) {
  if constexpr (dim == 2)
    return {numbers[0], numbers[1]};
  else
    return {numbers[0], numbers[1], numbers[2]};
}

/// The marker that a section of the case file is about.
Marker marker_of(const std::map<Marker, BoundaryCase>& conditions, const std::string& section) {
  for (const auto& [marker, boundary] : conditions)
    if (boundary.section == section) return marker;
  return {};
}

template <int dim>
BoundaryCondition<dim> condition_of(const BoundaryCase& boundary, double mach, const std::map<Marker, BoundaryCase>& all) {
  BoundaryCondition<dim> condition(boundary.kind);
  condition.total_pressure = boundary.total_pressure;
  condition.total_temperature = boundary.total_temperature;
  if (!boundary.direction.empty()) condition.direction = vector_of<dim>(boundary.direction);
  condition.pressure = boundary.pressure;
  condition.temperature = boundary.temperature;
  if (!boundary.velocity.empty()) condition.wall_velocity = mach * vector_of<dim>(boundary.velocity);
  if (boundary.kind == BoundaryKind::periodic) condition.partner = marker_of(all, boundary.partner);
  if (!boundary.translation.empty()) condition.translation = vector_of<dim>(boundary.translation);
  return condition;
}

}  // namespace

template <int dim>
FlowProblem<dim> problem_of(const Case& c, const std::map<Marker, BoundaryCase>& conditions, MeshDual<dim> dual) {
  const FlowCase& flow = c.flow;
  FlowProblem<dim> problem;
  problem.dual = std::move(dual);
  problem.gas = {flow.gamma};
  problem.free_stream = {flow.mach, radians(flow.alpha_deg), radians(flow.beta_deg)};
  problem.reference.length = c.reference.length;
  problem.reference.area = c.reference.area;
  problem.reference.moment_centre = typename Simplex<dim>::Point{} + vector_of<dim>(c.reference.moment_centre);
  problem.vortex_correction = c.farfield.vortex_correction;
  problem.vortex_centre = {c.reference.moment_centre[0], c.reference.moment_centre[1]};
  if (flow.reynolds)
    problem.viscosity = {.reynolds = *flow.reynolds,
                         .prandtl = flow.prandtl,
                         .sutherland = flow.viscosity == ViscosityLaw::constant ? -1 : sutherland_kelvin / flow.temperature};
  for (const auto& [marker, boundary] : conditions) {
    problem.boundary[marker] = condition_of<dim>(boundary, flow.mach, conditions);
    problem.dual.marker_names[marker] = boundary.name;
  }
  if (!c.initial.field.empty()) problem.initial = initial_states<dim>(c.initial.field, problem.dual.points);
  return problem;
}

template <int dim>
std::string match_periodic(const Case& c, const std::map<Marker, BoundaryCase>& conditions, const MeshDual<dim>& dual) {
  std::map<Marker, BoundaryCondition<dim>> boundary;
  for (const auto& [marker, condition] : conditions) boundary[marker] = condition_of<dim>(condition, c.flow.mach, conditions);
  std::string words;
  for (const PeriodicMatch<dim>& match : solver::match_periodic(dual, boundary))
    words += fmt::format("; {} and {} match, {} pairs of vertices within {:.1g}", conditions.at(match.from).name,
                         conditions.at(match.to).name, grouped(match.pairs.size()), match.mismatch);
  return words;
}

SteadyOptions options_of(const Case& c, int threads) {
  const SolverCase& s = c.solver;
  SteadyOptions options;
  options.marching = s.marching;
  options.flux = s.flux;
  options.limiter = s.limiter;
  options.r3_k = s.r3_k;
  options.venkatakrishnan_k = s.venkatakrishnan_k;
  options.entropy_fix = s.entropy_fix;
  options.order = s.order;
  options.cfl_start = s.cfl_start;
  options.cfl_max = s.cfl_max;
  options.residual_drop_orders = s.residual_drop_orders;
  options.settle_tolerance = s.settle_tolerance;
  options.settle_window = s.settle_window;
  options.max_iterations = s.max_iterations;
  options.threads = threads;
  return options;
}

template std::string match_periodic(const Case&, const std::map<Marker, BoundaryCase>&, const MeshDual<2>&);
template std::string match_periodic(const Case&, const std::map<Marker, BoundaryCase>&, const MeshDual<3>&);
template FlowProblem<2> problem_of(const Case&, const std::map<Marker, BoundaryCase>&, MeshDual<2>);
template FlowProblem<3> problem_of(const Case&, const std::map<Marker, BoundaryCase>&, MeshDual<3>);

}  // namespace leonhard::app
