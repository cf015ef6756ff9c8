// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "leonhard/solver/flux/viscous_constants.hpp"
#include "leonhard/solver/problem.hpp"

namespace leonhard::solver {

/// What the scheme sees of a boundary facet at one of its corners.
template <int dim>
struct BoundaryCorner {
  VertexId vertex;
  Axes<dim> n{};      ///< unit normal, outward
  double size{};      ///< of the corner's share of the facet
  double height{};    ///< of the vertex's control volume over its part of the boundary
  State<dim> outer{};  ///< outside (far field, supersonic inflow)
  Axes<2> vortex{};   ///< velocity per unit lift coefficient (far field of the plane)
};

/// How much of its own flux a corner's share of the facet carries; the others carry the rest in equal parts. Before a
/// triangle 5/6, before a tetrahedron 6/8, which makes the scheme exact for linear fluxes (as the Galerkin
/// method; H. Nishikawa, Journal of Computational Physics 281, 2015, section 4); before other cells 1, exact for linear fluxes
/// on rectangles and boxes of any spacing.
template <int dim>
[[nodiscard]] double corner_share(const DualFacet<dim>& facet) {
  return facet.cell != simplex_kind<dim> ? 1.0 : dim == 2 ? 5.0 / 6.0 : 6.0 / 8.0;
}

/// One boundary facet.
template <int dim>
struct BoundaryFacet {
  BoundaryCondition<dim> condition;
  std::vector<BoundaryCondition<dim>> varied{};  ///< one a corner where the condition varies along the boundary
  int corner_count{};
  double own_share{};  ///< see corner_share
  std::array<BoundaryCorner<dim>, MixedFacet<dim>::most_corners> corner{};

  [[nodiscard]] std::span<const BoundaryCorner<dim>> corners() const {
    return {corner.data(), static_cast<std::size_t>(corner_count)};
  }
  [[nodiscard]] const BoundaryCondition<dim>& condition_at(std::size_t c) const { return varied.empty() ? condition : varied[c]; }
  [[nodiscard]] double other_share() const { return (1 - own_share) / (corner_count - 1); }
};

/// The boundary of a problem, one entry per dual.boundary, outer states those of the free stream or of
/// problem.outer_state.
template <int dim>
[[nodiscard]] std::vector<BoundaryFacet<dim>> make_boundary(const FlowProblem<dim>& problem);

/// Velocity that a point vortex at `centre` adds at `at`, per unit lift coefficient: circulation
/// cl length |V_inf| / 2, clockwise, compressed by the Prandtl-Glauert rule (Thomas and Salas, AIAA Journal 24(7), 1986,
/// equation 9). Subsonic free streams only.
[[nodiscard]] Vec2 vortex_velocity(FreeStream free, Point2 centre, double length, Point2 at);

/// The free stream with the velocity `extra` added, at the same total enthalpy and entropy.
[[nodiscard]] State<2> isentropic_state(Gas gas, FreeStream free, Vec2 extra);

/// Set the outer states of far-field facets to the vortex of a lift coefficient; nothing in space.
template <int dim>
void set_far_field_lift(const FlowProblem<dim>& problem, double cl, std::span<BoundaryFacet<dim>> facets);

/// Whether the far field of this problem follows the lift.
template <int dim>
[[nodiscard]] bool follows_lift(const FlowProblem<dim>& problem);

/// What the boundary's fluxes know besides the states.
struct BoundaryConstants {
  Gas gas{};
  double entropy_fix = 0.05;
  FreeStream free_stream{};
};

/// Flux out through a unit of the boundary with the state w inside at one corner.
template <int dim>
[[nodiscard]] Conserved<dim> boundary_flux(const BoundaryConstants& constants, const BoundaryCondition<dim>& condition,
                                           const BoundaryCorner<dim>& corner, const State<dim>& w);

/// What friction and conduction add to it, by the gradients of the primitive variables at the corner (dim rows of dim + 2; nullptr
/// for none): all where the gas passes, with the jump to the outside over the height where there is an outside (far field,
/// supersonic inflow); the normal stress where it slips; nothing on no-slip walls, whose reaction StrongWalls finds.
template <int dim>
[[nodiscard]] Conserved<dim> viscous_boundary_flux(const ViscousConstants& constants, BoundaryKind kind,
                                                   const BoundaryCorner<dim>& corner, const State<dim>& w,
                                                   const double* gradient);

/// Add factor times the derivative of boundary_flux, and of viscous_boundary_flux without gradients, by the conservative variables
/// of w, exact, to a block, column by column.
template <int dim>
void add_boundary_jacobian(const BoundaryConstants& constants, const ViscousConstants& viscous,
                           const BoundaryCondition<dim>& condition, const BoundaryCorner<dim>& corner, const State<dim>& w,
                           double factor, double* block);

}  // namespace leonhard::solver
