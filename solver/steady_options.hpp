// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "leonhard/solver/kinds.hpp"

namespace leonhard {

/// How to march. The defaults are meant to work for every case from Mach 0.01 to 10.
struct SteadyOptions {
  Marching marching = Marching::implicit_ptc;
  FluxKind flux = FluxKind::roe_low_mach;  ///< between control volumes; the far field keeps Roe's
  std::optional<LimiterKind> limiter{};  ///< none: usual_limiter
  GradientKind gradient = GradientKind::least_squares;
  /// >= 0; larger limits less. A variation passes unlimited below (k h / extent)^1.5 of the local density, speed of sound
  /// or pressure times gamma; h is the control volume's root, in space its third root, the extent that of the walls, or of the mesh where there
  /// are none.
  double venkatakrishnan_k = 3.0;
  double r3_k = 5.0;                ///< likewise for nishikawa_r3, whose threshold is (k h / extent)^(4/3)
  int order = 2;                    ///< 1: states constant in a cell; 2: linear reconstruction
  double entropy_fix = 0.05;        ///< Harten's delta as a fraction of |Vn| + c, in [0, 1]
  std::optional<double> cfl_start{};  ///< none: chosen by the marching kind
  std::optional<double> cfl_max{};
  double residual_drop_orders = 8;  ///< converged once log10(|R0| / |R|) reaches this
  /// Settled once the force coefficients, and what FlowProblem::monitored names, move less than this (the latter as a share of
  /// their size where that is above 1) over settle_window iterations ...
  double settle_tolerance = 1e-6;
  std::optional<int> settle_window{};  ///< ... while the residual has stopped falling; none: usual_settle_window; 0: never
  int max_iterations = 0;              ///< 0: usual_max_iterations
  int threads = 1;         ///< >= 1; the result is the same to the bit for any value
  /// The parts over which the residual and the Jacobian are threaded: one number a vertex, each below `parts` (a part
  /// may be empty). Empty: parts of the solver's own making. The result is the same to the bit for any parts.
  std::vector<std::uint32_t> part_of{};
  std::uint32_t parts = 0;
  /// explicit_multistage: how strongly the steps of neighbouring vertices are brought together, >= 0; 0: not. With 0.15 the march
  /// bears a CFL number of 7 instead of 4; more than 0.2 gains nothing. Nothing of it is left in the steady state.
  double residual_smoothing = 0;
};

/// nishikawa_r3; in viscous flow at less than Mach 0.7, where no shock is to be expected, none: boundary layers lose accuracy by limiting.
[[nodiscard]] constexpr LimiterKind usual_limiter(double mach, bool viscous) {
  return viscous && mach < 0.7 ? LimiterKind::none : LimiterKind::nishikawa_r3;
}
[[nodiscard]] constexpr int usual_settle_window(Marching marching) { return marching == Marching::implicit_ptc ? 100 : 1000; }
[[nodiscard]] constexpr int usual_max_iterations(Marching marching) { return marching == Marching::implicit_ptc ? 500 : 50'000; }

}  // namespace leonhard
