// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "leonhard/mesh/id.hpp"
#include "leonhard/solver/problem.hpp"

namespace leonhard {

/// Coefficients of the pressure force, referred to rho_inf |V_inf|^2 / 2 times the reference length (cm:
/// times its square). cl is normal to the free stream, cd along it, cm nose up about the reference's moment
/// centre.
struct Forces {
  double cl{}, cd{}, cm{};
};

/// One vertex on a wall.
struct SurfacePoint {
  VertexId vertex;
  Point2 at;
  double arc_length{};  ///< from the body's first point, in the mesh's unit
  double cp{}, mach{};
};

/// One connected run of wall edges, in order with the flow on the left of the way of travel, starting at the
/// trailing edge (the vertex with the largest x) where it is a closed loop.
struct SurfaceLine {
  Marker marker{};  ///< of its first edge
  bool closed{};    ///< the last point is joined to the first, which is not repeated
  std::vector<SurfacePoint> points;
};

namespace solver {

/// The pressure force on every slip wall, by marker and in sum. The wall flux of the scheme weights the
/// pressures of an edge's ends (5/6, 1/6) and (1/6, 5/6) on its two halves; summed over the edge that is the
/// mean pressure times the edge's normal, which is what is added here: the forces are those the scheme's
/// momentum balance sees. Cost O(boundary edges), in the order of dual.boundary, whatever the thread count.
[[nodiscard]] std::map<Marker, Forces> wall_forces(const EulerProblem& problem,
                                                   const PerId<VertexId, State>& state);

/// The sum over all walls.
[[nodiscard]] Forces total(const std::map<Marker, Forces>& by_marker);

/// Cp and Mach number along every wall, body by body.
[[nodiscard]] std::vector<SurfaceLine> surface_lines(const EulerProblem& problem,
                                                     const PerId<VertexId, State>& state);

}  // namespace solver
}  // namespace leonhard
