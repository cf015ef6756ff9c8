// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/solver/gas.hpp"
#include "leonhard/solver/kinds.hpp"

namespace leonhard {

/// What coefficients refer to.
template <int dim>
struct Reference {
  using Point = typename Simplex<dim>::Point;
  double length = 1;                                          ///< > 0, in the mesh's unit
  double area = 1;                                            ///< > 0, in its square; space only, in the plane it is length
  Point moment_centre{0.25};  ///< positive moment: nose up
};

/// What happens at the boundary facets of one marker; made of a kind alone where that says all.
template <int dim>
struct BoundaryCondition {
  using Vector = typename Simplex<dim>::Vector;
  BoundaryCondition() = default;
  BoundaryCondition(BoundaryKind k) : kind(k) {}  // NOLINT(google-explicit-constructor): a kind is a condition

  BoundaryKind kind = BoundaryKind::slip_wall;
  /// subsonic_inflow: over the total pressure and total temperature of the free stream.
  double total_pressure = 1, total_temperature = 1;
  std::optional<Vector> direction{};  ///< subsonic_inflow: of any length, into the mesh; none: normal to the boundary
  double pressure = 1;                ///< pressure_outflow: over that of the free stream
  /// no_slip_wall: over the free stream's temperature; none: adiabatic.
  std::optional<double> temperature{};
  Vector wall_velocity{};  ///< no_slip_wall: in units of the free stream's speed of sound, along the wall
  Marker partner{};        ///< periodic: the other side, whose partner is this one
  /// periodic: from this side to its partner, given by one of the two at most; none: found from the mesh (mesh::match_sides).
  std::optional<Vector> translation{};
  /// far_field, supersonic_inflow: the state beyond; none: that of the free stream, or outer_state.
  std::optional<State<dim>> outer{};
  /// When set, gives the values above for a place on the boundary (not the kind, nor what makes it periodic). Called for each
  /// facet's corners when a march begins.
  std::function<void(const typename Simplex<dim>::Point&, BoundaryCondition&)> vary{};

  /// The condition at a place.
  [[nodiscard]] BoundaryCondition at(const typename Simplex<dim>::Point& place) const {
    BoundaryCondition here = *this;
    here.vary = nullptr;
    if (vary) vary(place, here);
    return here;
  }
};

/// The Euler equations about something in the plane or in space, or with a viscosity the Navier-Stokes equations.
template <int dim>
struct FlowProblem {
  using Point = typename Simplex<dim>::Point;

  MeshDual<dim> dual;  ///< mesh::build_dual of any cells
  Gas gas{};
  FreeStream free_stream{};
  std::map<Marker, BoundaryCondition<dim>> boundary{};  ///< one entry for each marker on dual.boundary, no other
  Reference<dim> reference{};
  /// Plane only: far-field states are those of a compressible point vortex whose circulation is that of the current lift
  /// (Thomas and Salas, AIAA Journal 24(7), 1986); ignored where the free stream is supersonic.
  bool vortex_correction = true;
  Point2 vortex_centre{0.25, 0};
  /// When set, replaces the free stream on far_field and supersonic_inflow (exact solutions, inflow
  /// profiles).
  std::function<State<dim>(Point)> outer_state{};
  std::optional<Viscosity> viscosity{};  ///< none: inviscid
  /// When set, what is added to each unit of volume in a unit of time at a point: conservative variables (manufactured
  /// solutions, body forces).
  std::function<std::array<double, dim + 2>(Point)> source{};
  /// Start from here in place of the free stream; one state a vertex, or empty. The implicit march leaves out its
  /// first-order start-up then.
  PerId<VertexId, State<dim>> initial{};
  /// Quantities by name, besides the force coefficients, that have to stand still before a march counts as settled; kept in
  /// Iteration::monitored in the order of their names. Without them and without walls: the means of kinetic energy and pressure.
  std::map<std::string, std::function<double(const PerId<VertexId, State<dim>>&)>> monitored{};
  bool rough_initial = false;  ///< the initial states are a guess: the start-up is kept
};

namespace solver {

/// Check a problem before any work.
/// throws  InputError naming the marker, value or vertex: an id out of range or an array of the wrong size, a control
///         volume that is not positive, a marker on the boundary without a condition, a condition whose marker is
///         nowhere, whose values are out of range or that needs a viscosity there is not, Mach <= 0 or not finite,
///         gamma <= 1, a reference length or area <= 0, a Reynolds or Prandtl number <= 0, an empty mesh, periodic sides
///         that do not match (mesh::match_sides) or are not each other's partners
template <int dim>
void check_problem(const FlowProblem<dim>& problem);

}  // namespace solver
}  // namespace leonhard
