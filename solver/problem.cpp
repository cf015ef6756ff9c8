// SPDX-License-Identifier: MIT
#include "leonhard/solver/problem.hpp"

#include <cmath>
#include <map>
#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/ids_in_range.hpp"

namespace leonhard {

namespace solver {
namespace {

std::string name_of(const TriangleMesh& mesh, Marker marker) {
  const auto found = mesh.marker_names.find(marker);
  const std::string number = "marker " + std::to_string(marker);
  return found == mesh.marker_names.end() ? number : number + " (\"" + found->second + "\")";
}

void check_number(bool good, const char* name, double value, const char* remedy) {
  if (!good) throw InputError(name, "is " + std::to_string(value), remedy);
}

void check_markers(const EulerProblem& problem) {
  std::map<Marker, std::size_t> edges_with;
  for (const MarkedEdge& edge : problem.mesh.boundary) ++edges_with[edge.marker];
  for (const auto& [marker, count] : edges_with) {
    if (!problem.boundary.contains(marker))
      throw InputError(
          "boundary",
          name_of(problem.mesh, marker) + " on " + std::to_string(count) + " boundary edges has no condition",
          "give it one, e.g. slip_wall or far_field");
  }
  for (const auto& [marker, kind] : problem.boundary) {
    if (!edges_with.contains(marker))
      throw InputError("boundary",
                       name_of(problem.mesh, marker) + " has the condition " + std::string(to_string(kind)) +
                           " but is on no boundary edge of the mesh",
                       "remove the condition or correct the marker");
  }
}

}  // namespace

void check_problem(const EulerProblem& problem) {
  if (problem.mesh.triangle_count() == 0)
    throw InputError("mesh", "has no triangles", "give a mesh of the flow domain");
  mesh::require_ids_in_range(problem.mesh);
  const FreeStream& free = problem.free_stream;
  check_number(std::isfinite(free.mach) && free.mach > 0, "mach", free.mach, "give a Mach number above 0");
  check_number(std::isfinite(free.alpha_rad), "alpha", free.alpha_rad, "give an angle of attack");
  check_number(std::isfinite(problem.gas.gamma) && problem.gas.gamma > 1, "gamma", problem.gas.gamma,
               "give a ratio of specific heats above 1, 1.4 for air");
  const double length = problem.reference.length;
  check_number(std::isfinite(length) && length > 0, "reference length", length,
               "give a length above 0, usually the chord");
  check_markers(problem);
}

}  // namespace solver
}  // namespace leonhard
