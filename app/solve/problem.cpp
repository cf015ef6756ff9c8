// SPDX-License-Identifier: MIT
#include "leonhard/app/solve/problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "leonhard/app/console.hpp"
#include "leonhard/app/solve/initial_field.hpp"
#include "leonhard/solver/axes.hpp"
#include "leonhard/solver/periodic.hpp"

namespace leonhard::app {
namespace {

constexpr double sutherland_kelvin = 110.4;  // air

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

Point3 in_space(Point2 p) { return {p.x, p.y, 0}; }
Point3 in_space(const Point3& p) { return p; }

template <int dim>
typename Simplex<dim>::Vector vector_of(const std::vector<double>& numbers) {
  if constexpr (dim == 2)
    return {numbers[0], numbers[1]};
  else
    return {numbers[0], numbers[1], numbers[2]};
}

template <int dim>
typename Simplex<dim>::Vector vector_at(const std::vector<PlaceValue>& values, const Point3& at) {
  std::vector<double> numbers;
  for (const PlaceValue& value : values) numbers.push_back(value(at));
  return vector_of<dim>(numbers);
}

double value_at(const std::optional<PlaceValue>& value, const Point3& at) { return value ? (*value)(at) : 1; }

/// A state from what is given of it: over the free stream's pressure, temperature and speed.
template <int dim>
State<dim> state_at(const FlowProblem<dim>& problem, const std::optional<PlaceValue>& pressure,
                    const std::optional<PlaceValue>& temperature, const std::vector<PlaceValue>& velocity, const Point3& at) {
  const double p = value_at(pressure, at);
  const State<dim> free = solver::free_stream_state<dim>(problem.gas, problem.free_stream);
  const auto speed = velocity.empty() ? solver::velocity(free)
                                      : solver::axes(problem.free_stream.mach * vector_at<dim>(velocity, at));
  return solver::state_with(p / value_at(temperature, at), speed, p / problem.gas.gamma);
}

bool vary(const std::vector<PlaceValue>& values) { return std::ranges::any_of(values, &PlaceValue::varies); }
bool vary(const std::optional<PlaceValue>& value) { return value && value->varies(); }

/// The numbers of a boundary at a place.
template <int dim>
void set_values(const FlowProblem<dim>& problem, const BoundaryCase& boundary, const Point3& at, BoundaryCondition<dim>& condition) {
  condition.total_pressure = boundary.total_pressure(at);
  condition.total_temperature = boundary.total_temperature(at);
  if (!boundary.direction.empty()) condition.direction = vector_at<dim>(boundary.direction, at);
  if (boundary.kind == BoundaryKind::no_slip_wall) {
    if (boundary.temperature) condition.temperature = (*boundary.temperature)(at);
    if (!boundary.velocity.empty()) condition.wall_velocity = problem.free_stream.mach * vector_at<dim>(boundary.velocity, at);
  } else if (boundary.kind == BoundaryKind::pressure_outflow) {
    condition.pressure = value_at(boundary.pressure, at);
  } else if (boundary.pressure || boundary.temperature || !boundary.velocity.empty()) {
    condition.outer = state_at(problem, boundary.pressure, boundary.temperature, boundary.velocity, at);
  }
}

/// The marker that a section of the case file is about.
Marker marker_of(const std::map<Marker, BoundaryCase>& conditions, const std::string& section) {
  for (const auto& [marker, boundary] : conditions)
    if (boundary.section == section) return marker;
  return {};
}

/// problem  its gas and free stream
template <int dim>
BoundaryCondition<dim> condition_of(const FlowProblem<dim>& problem, const BoundaryCase& boundary,
                                    const std::map<Marker, BoundaryCase>& all) {
  BoundaryCondition<dim> condition(boundary.kind);
  if (boundary.kind == BoundaryKind::periodic) condition.partner = marker_of(all, boundary.partner);
  if (!boundary.translation.empty()) condition.translation = vector_of<dim>(boundary.translation);
  FlowProblem<dim> flow;
  flow.gas = problem.gas, flow.free_stream = problem.free_stream;
  if (boundary.total_pressure.varies() || boundary.total_temperature.varies() || vary(boundary.pressure) ||
      vary(boundary.temperature) || vary(boundary.velocity) || vary(boundary.direction))
    condition.vary = [flow, boundary](const auto& at, BoundaryCondition<dim>& here) { set_values(flow, boundary, in_space(at), here); };
  else
    set_values(flow, boundary, Point3{}, condition);
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
    problem.boundary[marker] = condition_of(problem, boundary, conditions);
    problem.dual.marker_names[marker] = boundary.name;
  }
  if (c.initial.has_values()) {
    problem.rough_initial = true;
    for (const auto& at : problem.dual.points)
      problem.initial.push_back(state_at(problem, c.initial.pressure, c.initial.temperature, c.initial.velocity, in_space(at)));
  }
  if (!c.initial.field.empty()) problem.initial = initial_states<dim>(c.initial.field, problem.dual.points);
  return problem;
}

template <int dim>
std::string match_periodic(const Case& c, const std::map<Marker, BoundaryCase>& conditions, const MeshDual<dim>& dual) {
  FlowProblem<dim> flow;
  flow.free_stream.mach = c.flow.mach;
  std::map<Marker, BoundaryCondition<dim>> boundary;
  for (const auto& [marker, condition] : conditions) boundary[marker] = condition_of(flow, condition, conditions);
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
  options.gradient = s.gradient;
  options.r3_k = s.r3_k;
  options.venkatakrishnan_k = s.venkatakrishnan_k;
  options.entropy_fix = s.entropy_fix;
  options.order = s.order;
  options.cfl_start = s.cfl_start;
  options.cfl_max = s.cfl_max;
  options.residual_drop_orders = s.residual_drop_orders;
  options.settle_tolerance = s.settle_tolerance;
  options.settle_window = s.settle_window;
  options.residual_smoothing = s.residual_smoothing;
  options.max_iterations = s.max_iterations;
  options.threads = threads;
  return options;
}

template std::string match_periodic(const Case&, const std::map<Marker, BoundaryCase>&, const MeshDual<2>&);
template std::string match_periodic(const Case&, const std::map<Marker, BoundaryCase>&, const MeshDual<3>&);
template FlowProblem<2> problem_of(const Case&, const std::map<Marker, BoundaryCase>&, MeshDual<2>);
template FlowProblem<3> problem_of(const Case&, const std::map<Marker, BoundaryCase>&, MeshDual<3>);

}  // namespace leonhard::app
