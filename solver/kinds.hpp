// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

// The choices that a case makes among methods, each by one enum for library, sweeps and case files alike.

namespace leonhard {

/// What happens at a part of the boundary.
enum class BoundaryKind {
  slip_wall,           ///< no flow through it; forces are summed over it
  far_field,           ///< Roe flux against the free stream: in and out by characteristics
  supersonic_inflow,   ///< everything is prescribed
  supersonic_outflow,  ///< everything is taken from inside
  symmetry,            ///< as a slip wall, without forces
};

/// How a reconstructed gradient is limited; the formulas are in sweep/limiter.hpp.
enum class LimiterKind { none, venkatakrishnan, barth_jespersen };

/// How the steady state is reached.
enum class Marching {
  implicit_ptc,         ///< pseudo-transient continuation, Newton-Krylov at the end: the default, needs no tuning
  explicit_multistage,  ///< three-stage Runge-Kutta with local time steps
};

/// The words of reports, e.g. "slip_wall".
[[nodiscard]] constexpr std::string_view to_string(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::slip_wall:
      return "slip_wall";
    case BoundaryKind::far_field:
      return "far_field";
    case BoundaryKind::supersonic_inflow:
      return "supersonic_inflow";
    case BoundaryKind::supersonic_outflow:
      return "supersonic_outflow";
    case BoundaryKind::symmetry:
      return "symmetry";
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
