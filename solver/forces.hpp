// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <span>
#include <vector>

#include "leonhard/mesh/id.hpp"
#include "leonhard/solver/problem.hpp"
#include "leonhard/solver/sweep/strong_walls.hpp"

namespace leonhard {

/// Coefficients of the force on walls, referred to rho_inf |V_inf|^2 / 2 times the reference length (in space the reference area;
/// moments: times the length once more). cl is normal to the free stream (in space: in the plane of x and z), cd along it; moments
/// are about the reference's moment centre.
struct Forces {
  double cl{}, cd{};
  double cm{};                              ///< nose up: about the y axis in space
  double cy{};                              ///< side force, along y and normal to the free stream; space only
  double roll{}, yaw{};                     ///< about x and z, right-handed; space only
  double cl_friction{}, cd_friction{};      ///< the part of cl and cd that is friction

  Forces& operator+=(const Forces& other) {
    cl += other.cl, cd += other.cd, cm += other.cm, cy += other.cy, roll += other.roll, yaw += other.yaw;
    cl_friction += other.cl_friction, cd_friction += other.cd_friction;
    return *this;
  }
};

/// One vertex on a wall of the plane.
struct SurfacePoint {
  VertexId vertex;
  Point2 at;
  double arc_length{};  ///< from the body's first point, in the mesh's unit
  double cp{}, mach{};
  /// Friction over rho_inf |V_inf|^2 / 2, positive where it pulls downstream: along the wall's direction that makes an acute angle
  /// with the free stream. 0 on slip walls.
  double cf{};
  double heat{};  ///< into the wall, over rho_inf |V_inf|^3; 0 on adiabatic walls
  /// Height of the first cell, twice the control volume over its part of the wall, in units of kinematic viscosity over friction
  /// velocity; 0 on slip walls.
  double y_plus{};
};

/// One connected run of wall edges, in order with the flow on the left of the way of travel, starting at the
/// trailing edge (the vertex with the largest x) where it is a closed loop.
struct SurfaceLine {
  Marker marker{};  ///< of its first edge
  bool closed{};    ///< the last point is joined to the first, which is not repeated
  std::vector<SurfacePoint> points;
};

namespace solver {

/// What the flow does to one vertex of a no-slip wall, per unit of the wall.
template <int dim>
struct WallStress {
  StrongVertex<dim> at;
  Axes<dim> friction{};  ///< over rho_inf |V_inf|^2 / 2
  double heat{};         ///< into the wall, over rho_inf |V_inf|^3
  double y_plus{};       ///< see SurfacePoint
};

/// Reactions (see StrongWalls, one for each of `vertices`) as stresses.
template <int dim>
[[nodiscard]] std::vector<WallStress<dim>> wall_stresses(const FlowProblem<dim>& problem,
                                                         const PerId<VertexId, State<dim>>& state,
                                                         const std::vector<StrongVertex<dim>>& vertices,
                                                         const std::vector<WallReaction<dim>>& reactions);

/// The force on every wall, by marker: pressure, and friction where stresses are given. Both are those of the scheme's momentum
/// balance: the pressures of a facet's corners have the weights of the wall flux (summed over an edge or a triangle, the mean). Cost O(boundary facets), in the order of dual.boundary,
/// whatever the thread count.
template <int dim>
[[nodiscard]] std::map<Marker, Forces> wall_forces(const FlowProblem<dim>& problem,
                                                   const PerId<VertexId, State<dim>>& state,
                                                   const std::vector<WallStress<dim>>& stresses = {});

/// The sum over all walls.
[[nodiscard]] Forces total(const std::map<Marker, Forces>& by_marker);

/// Cp, Mach number and friction along every wall of the plane, body by body.
[[nodiscard]] std::vector<SurfaceLine> surface_lines(const FlowProblem<2>& problem,
                                                     const PerId<VertexId, State<2>>& state,
                                                     const std::vector<WallStress<2>>& stresses = {});

}  // namespace solver
}  // namespace leonhard
