// SPDX-License-Identifier: MIT
#pragma once

namespace leonhard::solver {

/// What the viscous terms know besides the states.
struct ViscousConstants {
  double gamma = 1.4;
  double viscosity = 0;    ///< at the free stream's temperature, in units of rho_inf c_inf length
  double sutherland = -1;  ///< see Viscosity
  double inverse_prandtl = 1;
};

}  // namespace leonhard::solver
