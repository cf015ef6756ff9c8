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
[[nodiscard]] std::string_view to_string(BoundaryKind kind);
[[nodiscard]] std::string_view to_string(LimiterKind kind);
[[nodiscard]] std::string_view to_string(Marching marching);

}  // namespace leonhard
