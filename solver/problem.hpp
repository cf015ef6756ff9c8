// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>

#include "leonhard/mesh/mesh_dual.hpp"
#include "leonhard/solver/gas.hpp"
#include "leonhard/solver/kinds.hpp"

namespace leonhard {

/// What coefficients refer to: length is also the reference area per unit span.
struct Reference {
  double length = 1;              ///< > 0, in the mesh's unit
  Point2 moment_centre{0.25, 0};  ///< positive moment: nose up
};

/// The Euler equations about something.
struct EulerProblem {
  MeshDual<2> dual;  ///< mesh::build_dual of triangles, or of triangles and quadrilaterals
  Gas gas{};
  FreeStream free_stream{};
  std::map<Marker, BoundaryKind> boundary{};  ///< one entry for each marker on dual.boundary, no other
  Reference reference{};
  /// Far-field states are those of a compressible point vortex whose circulation is that of the current lift
  /// (Thomas and Salas, AIAA Journal 24(7), 1986); ignored where the free stream is supersonic.
  bool vortex_correction = true;
  Point2 vortex_centre{0.25, 0};
  /// When set, replaces the free stream on far_field and supersonic_inflow (exact solutions, inflow
  /// profiles).
  std::function<State(Point2)> outer_state{};
};

namespace solver {

/// Check a problem before any work.
/// throws  InputError naming the marker, value or vertex: an id out of range or an array of the wrong size, a control
///         volume that is not positive, a marker on the boundary without a condition, a condition whose marker is
///         nowhere, Mach <= 0 or not finite, gamma <= 1, a reference length <= 0, an empty mesh
void check_problem(const EulerProblem& problem);

}  // namespace solver
}  // namespace leonhard
