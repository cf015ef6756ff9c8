// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "leonhard/solver/problem.hpp"

namespace leonhard::solver {

/// One boundary edge as the scheme sees it. Its half at each end carries a share of that end's flux and the rest of the
/// other's: before a triangle 5/6 and 1/6, which makes the scheme exact for linear fluxes (as the Galerkin method; H.
/// Nishikawa, Journal of Computational Physics 281, 2015, section 4); before a quadrilateral all is the end's own, exact for
/// linear fluxes on rectangles of any spacing.
struct BoundaryEdge {
  VertexId end[2];
  BoundaryKind kind{};
  double nx{}, ny{};  ///< unit normal, outward
  double half_length{};
  double own_share{};
  State outer[2];  ///< outside each end (far field, supersonic inflow)
  Vec2 vortex[2];  ///< velocity at each end per unit lift coefficient (far field)
};

/// The boundary of a problem, one entry per dual.boundary, outer states those of the free stream or of
/// problem.outer_state.
[[nodiscard]] std::vector<BoundaryEdge> make_boundary(const EulerProblem& problem);

/// Velocity that a point vortex at `centre` adds at `at`, per unit lift coefficient: circulation
/// cl length |V_inf| / 2, clockwise, compressed by the Prandtl-Glauert rule (Thomas and Salas, AIAA Journal 24(7), 1986,
/// equation 9). Subsonic free streams only.
[[nodiscard]] Vec2 vortex_velocity(FreeStream free, Point2 centre, double length, Point2 at);

/// The free stream with the velocity `extra` added, at the same total enthalpy and entropy.
[[nodiscard]] State isentropic_state(Gas gas, FreeStream free, Vec2 extra);

/// Set the outer states of far-field edges to the vortex of a lift coefficient.
void set_far_field_lift(const EulerProblem& problem, double cl, std::span<BoundaryEdge> edges);

/// Whether the far field of this problem follows the lift.
[[nodiscard]] bool follows_lift(const EulerProblem& problem);

/// Flux out through a unit length of the boundary with the state w inside at one end.
[[nodiscard]] Conserved boundary_flux(Gas gas, double entropy_fix, const BoundaryEdge& edge, int end,
                                      const State& w);

/// Add factor times the derivative of boundary_flux by the conservative variables of w to a block, column by column.
void add_boundary_jacobian(Gas gas, double entropy_fix, const BoundaryEdge& edge, int end, const State& w,
                           double factor, double* block);

}  // namespace leonhard::solver
