// SPDX-License-Identifier: MIT
#include "leonhard/solver/problem.hpp"

#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/solver/periodic.hpp"

namespace leonhard {

namespace solver {
namespace {

constexpr const char* remake = "make it with mesh::build_dual";

template <int dim>
std::string name_of(const MeshDual<dim>& dual, Marker marker) {
  const auto found = dual.marker_names.find(marker);
  const std::string number = "marker " + std::to_string(marker);
  return found == dual.marker_names.end() ? number : number + " (\"" + found->second + "\")";
}

void check_number(bool good, const std::string& name, double value, const char* remedy) {
  if (good) return;
  std::ostringstream words;
  words << "is " << value;
  throw InputError(name, words.str(), remedy);
}

bool above_zero(double x) { return std::isfinite(x) && x > 0; }

template <int dim>
void check_sizes(const MeshDual<dim>& dual) {
  if (dual.vertex_count() == 0 || dual.edge_count() == 0)
    throw InputError("mesh", "has no cells", "give a mesh of the flow domain");
  if (dual.edges.first_edge.size() != dual.vertex_count() + 1 || dual.face.size() != dual.edge_count() ||
      dual.volume.size() != dual.vertex_count())
    throw InputError("dual",
                     "has " + std::to_string(dual.face.size()) + " faces for " +
                         std::to_string(dual.edge_count()) + " edges and " + std::to_string(dual.volume.size()) +
                         " volumes for " + std::to_string(dual.vertex_count()) + " vertices",
                     remake);
}

template <int dim>
void check_boundary_ids(const MeshDual<dim>& dual, const auto& check_vertex) {
  for (const DualFacet<dim>& facet : dual.boundary) {
    if (facet.corners.size() < std::size_t{dim})
      throw InputError("dual", "has a boundary facet of " + std::to_string(facet.corners.size()) + " corners", remake);
    for (const VertexId v : facet.corners) check_vertex(v, "the boundary");
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
      const VertexId a = facet.corners[i], b = facet.corners[(i + 1) % facet.corners.size()];
      if (!dual.edges.find(a, b))
        throw InputError("dual",
                         "has a boundary edge " + std::to_string(a.raw) + "-" + std::to_string(b.raw) +
                             " that is no edge of a cell",
                         remake);
    }
  }
}

/// What the sweeps rely on, so that they read nothing beyond an array's end and divide by no volume of 0.
template <int dim>
void check_dual(const MeshDual<dim>& dual) {
  check_sizes(dual);
  const auto check_vertex = [&](VertexId v, const char* of) {
    if (!dual.points.contains(v))
      throw InputError("dual", "vertex " + std::to_string(v.raw) + " of " + of + " does not exist", remake);
  };
  for (const auto& ends : dual.edges.ends)
    for (const VertexId v : ends) check_vertex(v, "an edge");
  check_boundary_ids(dual, check_vertex);
  for (const VertexId v : dual.volume.ids()) {
    if (dual.volume[v] > 0) continue;
    std::ostringstream words;
    words << "the control volume about vertex " << v.raw << " at " << dual.points[v] << " is " << dual.volume[v];
    throw InputError("mesh", words.str(), "check the cells about it: each must be convex and positive");
  }
}

template <int dim>
void check_markers(const FlowProblem<dim>& problem) {
  std::map<Marker, std::size_t> facets_with;
  const std::string facets = dim == 2 ? " boundary edges" : " boundary faces";
  for (const DualFacet<dim>& facet : problem.dual.boundary) ++facets_with[facet.marker];
  for (const auto& [marker, count] : facets_with) {
    if (!problem.boundary.contains(marker))
      throw InputError("boundary",
                       name_of(problem.dual, marker) + " on " + std::to_string(count) + facets + " has no condition",
                       "give it one, e.g. slip_wall or far_field");
  }
  for (const auto& [marker, condition] : problem.boundary) {
    if (!facets_with.contains(marker))
      throw InputError("boundary",
                       name_of(problem.dual, marker) + " has the condition " + std::string(to_string(condition.kind)) +
                           " but is on no boundary " + (dim == 2 ? "edge" : "face") + " of the mesh",
                       "remove the condition or correct the marker");
  }
}

/// The values that a marker's condition gives, everywhere or at a corner of a facet.
template <int dim>
void check_values(const FlowProblem<dim>& problem, Marker marker, const BoundaryCondition<dim>& condition,
                  const std::string& place) {
  const std::string of = " of " + name_of(problem.dual, marker) + place;
  check_number(above_zero(condition.total_pressure), "total pressure" + of, condition.total_pressure,
               "give a ratio above 0, 1 for that of the free stream");
  check_number(above_zero(condition.total_temperature), "total temperature" + of, condition.total_temperature,
               "give a ratio above 0, 1 for that of the free stream");
  check_number(above_zero(condition.pressure), "pressure" + of, condition.pressure,
               "give a ratio above 0, 1 for that of the free stream");
  check_number(!condition.temperature || above_zero(*condition.temperature), "temperature" + of,
               condition.temperature.value_or(0), "give a ratio above 0, 1 for that of the free stream");
  check_number(std::isfinite(norm(condition.wall_velocity)), "wall velocity" + of, norm(condition.wall_velocity),
               "give numbers");
  check_number(!condition.direction || above_zero(norm(*condition.direction)), "direction" + of,
               condition.direction ? norm(*condition.direction) : 0, "give a vector that is not 0");
  check_number(!condition.outer || is_physical(*condition.outer), "state beyond" + of,
               condition.outer ? condition.outer->p : 0, "give finite numbers, density and pressure above 0");
}

/// Where a condition's direction leads, and whether the flow has what the condition needs.
template <int dim>
void check_condition(const FlowProblem<dim>& problem, Marker marker, const BoundaryCondition<dim>& condition) {
  const std::string of = " of " + name_of(problem.dual, marker);
  if (!condition.vary) check_values(problem, marker, condition, "");
  if (condition.vary || (condition.kind == BoundaryKind::subsonic_inflow && condition.direction))
    for (const DualFacet<dim>& facet : problem.dual.boundary)
      if (facet.marker == marker)
        for (const VertexId v : facet.corners) {
          std::ostringstream place;
          place << " at " << problem.dual.points[v];
          const BoundaryCondition<dim> here = condition.at(problem.dual.points[v]);
          if (condition.vary) check_values(problem, marker, here, place.str());
          if (here.kind == BoundaryKind::subsonic_inflow && here.direction && !(dot(*here.direction, facet.normal) < 0))
            throw InputError("direction" + of, "points out of the mesh" + place.str(),
                             "turn it, or leave it out for an inflow normal to the boundary");
        }
  if (condition.kind == BoundaryKind::no_slip_wall && !problem.viscosity)
    throw InputError("boundary", name_of(problem.dual, marker) + " is a no-slip wall in a flow without viscosity",
                     "give a Reynolds number, or make it a slip wall");
}

}  // namespace

template <int dim>
void check_problem(const FlowProblem<dim>& problem) {
  check_dual(problem.dual);
  const FreeStream& free = problem.free_stream;
  check_number(above_zero(free.mach), "mach", free.mach, "give a Mach number above 0");
  check_number(std::isfinite(free.alpha_rad), "alpha", free.alpha_rad, "give an angle of attack");
  check_number(std::isfinite(free.beta_rad), "beta", free.beta_rad, "give an angle of sideslip");
  check_number(std::isfinite(problem.gas.gamma) && problem.gas.gamma > 1, "gamma", problem.gas.gamma,
               "give a ratio of specific heats above 1, 1.4 for air");
  check_number(above_zero(problem.reference.length), "reference length", problem.reference.length,
               "give a length above 0, usually the chord");
  check_number(above_zero(problem.reference.area), "reference area", problem.reference.area,
               "give an area above 0, usually that of the wing");
  if (problem.viscosity) {
    check_number(above_zero(problem.viscosity->reynolds), "reynolds", problem.viscosity->reynolds,
                 "give a Reynolds number above 0");
    check_number(above_zero(problem.viscosity->prandtl), "prandtl", problem.viscosity->prandtl,
                 "give a Prandtl number above 0, 0.72 for air");
    check_number(std::isfinite(problem.viscosity->sutherland), "sutherland", problem.viscosity->sutherland,
                 "give a ratio of temperatures, or a negative number for a constant viscosity");
  }
  if (!problem.initial.empty() && problem.initial.size() != problem.dual.vertex_count())
    throw InputError("initial",
                     "has " + std::to_string(problem.initial.size()) + " states for " +
                         std::to_string(problem.dual.vertex_count()) + " vertices",
                     "give one state a vertex, or none");
  check_markers(problem);
  for (const auto& [marker, condition] : problem.boundary) check_condition(problem, marker, condition);
  (void)match_periodic(problem.dual, problem.boundary);
}

template void check_problem(const FlowProblem<2>&);
template void check_problem(const FlowProblem<3>&);

}  // namespace solver
}  // namespace leonhard
