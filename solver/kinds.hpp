// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

// The choices that a case makes among methods, each by one enum for library, sweeps and case files alike.

namespace leonhard {

/// What happens at a part of the boundary.
enum class BoundaryKind {
  slip_wall,           ///< no flow through it; forces are summed over it
  no_slip_wall,        ///< the gas moves with the wall, through which no heat goes or which has a temperature; viscous flow only
  far_field,           ///< Roe flux against the free stream: in and out by characteristics
  supersonic_inflow,   ///< everything is prescribed
  supersonic_outflow,  ///< everything is taken from inside
  subsonic_inflow,     ///< total pressure, total temperature and direction are prescribed
  pressure_outflow,    ///< static pressure is prescribed where the flow out is subsonic
  symmetry,            ///< as a slip wall, without forces
  periodic,            ///< joined to its partner, the same side moved by a translation
};

/// How the flux between two control volumes is computed; a file each in flux/, docs/solver.md tells when to take which.
enum class FluxKind {
  roe,            ///< characteristic by characteristic
  roe_low_mach,   ///< without the error that grows as the Mach number goes to 0: the default
  hllc,           ///< keeps density and pressure positive
  hllc_low_mach,  ///< likewise, for small Mach numbers
  ausm_plus_up,   ///< for all Mach numbers
  rusanov,        ///< the most dissipative and the most robust
  van_leer,       ///< smooth; smears contacts and shear
  kep_scalar,     ///< central, keeps kinetic energy, makes entropy; dissipation by the fastest wave
  kep_matrix,     ///< likewise, dissipation wave by wave
};

/// How a reconstructed gradient is limited; the formulas are in sweep/limiter.hpp.
enum class LimiterKind { none, venkatakrishnan, barth_jespersen, nishikawa_r3 };

/// How gradients at the vertices are made.
enum class GradientKind {
  least_squares,  ///< over the edges, weighted by the inverse of the distance: exact for linear functions on any cells
  green_gauss,    ///< by the control volume's surface; exact for linear functions on simplices; on the boundary least squares
};

/// How the steady state is reached.
enum class Marching {
  implicit_ptc,         ///< pseudo-transient continuation, Newton-Krylov at the end: the default, needs no tuning
  explicit_multistage,  ///< three-stage Runge-Kutta with local time steps
};

/// Whether forces are summed over it.
[[nodiscard]] constexpr bool is_wall(BoundaryKind kind) {
  return kind == BoundaryKind::slip_wall || kind == BoundaryKind::no_slip_wall;
}

/// The words of reports, e.g. "slip_wall".
[[nodiscard]] constexpr std::string_view to_string(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::slip_wall:
      return "slip_wall";
    case BoundaryKind::no_slip_wall:
      return "no_slip_wall";
    case BoundaryKind::far_field:
      return "far_field";
    case BoundaryKind::supersonic_inflow:
      return "supersonic_inflow";
    case BoundaryKind::supersonic_outflow:
      return "supersonic_outflow";
    case BoundaryKind::subsonic_inflow:
      return "subsonic_inflow";
    case BoundaryKind::pressure_outflow:
      return "pressure_outflow";
    case BoundaryKind::symmetry:
      return "symmetry";
    case BoundaryKind::periodic:
      return "periodic";
  }
  return "";
}

[[nodiscard]] constexpr std::string_view to_string(FluxKind kind) {
  switch (kind) {
    case FluxKind::roe:
      return "roe";
    case FluxKind::roe_low_mach:
      return "roe_low_mach";
    case FluxKind::hllc:
      return "hllc";
    case FluxKind::hllc_low_mach:
      return "hllc_low_mach";
    case FluxKind::ausm_plus_up:
      return "ausm_plus_up";
    case FluxKind::rusanov:
      return "rusanov";
    case FluxKind::van_leer:
      return "van_leer";
    case FluxKind::kep_scalar:
      return "kep_scalar";
    case FluxKind::kep_matrix:
      return "kep_matrix";
  }
  return "";
}

[[nodiscard]] constexpr std::string_view to_string(LimiterKind kind) {
  switch (kind) {
    case LimiterKind::none:
      return "none";
    case LimiterKind::venkatakrishnan:
      return "venkatakrishnan";
    case LimiterKind::barth_jespersen:
      return "barth_jespersen";
    case LimiterKind::nishikawa_r3:
      return "nishikawa_r3";
  }
  return "";
}

[[nodiscard]] constexpr std::string_view to_string(Marching marching) {
  switch (marching) {
    case Marching::implicit_ptc:
      return "implicit_ptc";
    case Marching::explicit_multistage:
      return "explicit_multistage";
  }
  return "";
}

}  // namespace leonhard
