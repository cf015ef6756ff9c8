// SPDX-License-Identifier: MIT
#include "leonhard/solver/problem.hpp"

#include <cmath>
#include <map>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard {

namespace solver {
namespace {

std::string name_of(const MeshDual<2>& dual, Marker marker) {
  const auto found = dual.marker_names.find(marker);
  const std::string number = "marker " + std::to_string(marker);
  return found == dual.marker_names.end() ? number : number + " (\"" + found->second + "\")";
}

void check_number(bool good, const char* name, double value, const char* remedy) {
  if (!good) throw InputError(name, "is " + std::to_string(value), remedy);
}

/// What the sweeps rely on, so that they read nothing beyond an array's end and divide by no volume of 0.
void check_dual(const MeshDual<2>& dual) {
  if (dual.vertex_count() == 0 || dual.edge_count() == 0)
    throw InputError("mesh", "has no cells", "give a mesh of the flow domain");
  if (dual.edges.first_edge.size() != dual.vertex_count() + 1 || dual.face.size() != dual.edge_count() || dual.volume.size() != dual.vertex_count())
    throw InputError("dual",
                     "has " + std::to_string(dual.face.size()) + " faces for " +
                         std::to_string(dual.edge_count()) + " edges and " + std::to_string(dual.volume.size()) +
                         " volumes for " + std::to_string(dual.vertex_count()) + " vertices",
                     "make it with mesh::build_dual");
  const auto check_vertex = [&](VertexId v, const char* of) {
    if (!dual.points.contains(v))
      throw InputError("dual", "vertex " + std::to_string(v.raw) + " of " + of + " does not exist",
                       "make it with mesh::build_dual");
  };
  for (const auto& ends : dual.edges.ends)
    for (const VertexId v : ends) check_vertex(v, "an edge");
  for (const DualFacet<2>& edge : dual.boundary) {
    if (edge.corners.size() != 2)
      throw InputError("dual", "has a boundary edge without two ends", "make it with mesh::build_dual");
    for (const VertexId v : edge.corners) check_vertex(v, "the boundary");
    if (!dual.edges.find(edge.corners[0], edge.corners[1]))
      throw InputError("dual",
                       "has a boundary edge " + std::to_string(edge.corners[0].raw) + "-" +
                           std::to_string(edge.corners[1].raw) + " that is no edge of a cell",
                       "make it with mesh::build_dual");
  }
  for (const VertexId v : dual.volume.ids()) {
    if (dual.volume[v] > 0) continue;
    const Point2 p = dual.points[v];
    throw InputError("mesh",
                     "the control volume about vertex " + std::to_string(v.raw) + " at (" + std::to_string(p.x) + ", " +
                         std::to_string(p.y) + ") is " + std::to_string(dual.volume[v]),
                     "check the cells about it: each must be convex and positive");
  }
}

void check_markers(const EulerProblem& problem) {
  std::map<Marker, std::size_t> edges_with;
  for (const DualFacet<2>& edge : problem.dual.boundary) ++edges_with[edge.marker];
  for (const auto& [marker, count] : edges_with) {
    if (!problem.boundary.contains(marker))
      throw InputError(
          "boundary",
          name_of(problem.dual, marker) + " on " + std::to_string(count) + " boundary edges has no condition",
          "give it one, e.g. slip_wall or far_field");
  }
  for (const auto& [marker, kind] : problem.boundary) {
    if (!edges_with.contains(marker))
      throw InputError("boundary",
                       name_of(problem.dual, marker) + " has the condition " + std::string(to_string(kind)) +
                           " but is on no boundary edge of the mesh",
                       "remove the condition or correct the marker");
  }
}

}  // namespace

void check_problem(const EulerProblem& problem) {
  check_dual(problem.dual);
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
