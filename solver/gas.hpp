// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "leonhard/kernel/point.hpp"

namespace leonhard {

/// A calorically perfect gas. Everything is non-dimensional: far upstream rho = 1, speed of sound = 1, hence
/// p = 1/gamma and |V| = the Mach number.
struct Gas {
  double gamma = 1.4;  ///< ratio of specific heats, > 1
};

/// The undisturbed flow.
struct FreeStream {
  double mach = 0.5;     ///< > 0
  double alpha_rad = 0;  ///< angle of attack, counter-clockwise from the x axis
};

/// Primitive variables at a point. 32-byte aligned so that one state is one vector register.
struct alignas(32) State {
  double rho{}, u{}, v{}, p{};
  friend constexpr bool operator==(const State&, const State&) = default;
};

namespace solver {

/// Conservative variables (rho, rho u, rho v, rho E), or a flux or residual of them.
using Conserved = std::array<double, 4>;

/// The state far upstream. Pure.
[[nodiscard]] inline State free_stream_state(Gas gas, FreeStream free) {
  return {1.0, free.mach * std::cos(free.alpha_rad), free.mach * std::sin(free.alpha_rad), 1.0 / gas.gamma};
}

/// rho > 0, p > 0 and all four finite.
[[nodiscard]] inline bool is_physical(const State& w) {
  return std::isfinite(w.u) && std::isfinite(w.v) && w.rho > 0 && w.p > 0 && std::isfinite(w.rho) &&
         std::isfinite(w.p);
}

[[nodiscard]] inline Conserved conserved_of(Gas gas, const State& w) {
  return {w.rho, w.rho * w.u, w.rho * w.v, w.p / (gas.gamma - 1) + 0.5 * w.rho * (w.u * w.u + w.v * w.v)};
}

[[nodiscard]] inline State state_of(Gas gas, const Conserved& q) {
  const double u = q[1] / q[0], v = q[2] / q[0];
  return {q[0], u, v, (gas.gamma - 1) * (q[3] - 0.5 * (q[1] * u + q[2] * v))};
}

[[nodiscard]] inline double sound_speed(Gas gas, const State& w) {
  return std::sqrt(gas.gamma * w.p / w.rho);
}

[[nodiscard]] inline double mach_number(Gas gas, const State& w) {
  return std::hypot(w.u, w.v) / sound_speed(gas, w);
}

/// (p - p_inf) / (rho_inf |V_inf|^2 / 2).
[[nodiscard]] inline double pressure_coefficient(Gas gas, FreeStream free, double p) {
  return (p - 1.0 / gas.gamma) / (0.5 * free.mach * free.mach);
}

/// Total pressure over that of the free stream; 1 where the flow is isentropic and uniform upstream.
[[nodiscard]] inline double total_pressure_ratio(Gas gas, FreeStream free, const State& w) {
  const auto head = [&](double m2) {
    return std::pow(1 + 0.5 * (gas.gamma - 1) * m2, gas.gamma / (gas.gamma - 1));
  };
  const double m = mach_number(gas, w);
  return w.p * gas.gamma * head(m * m) / head(free.mach * free.mach);
}

}  // namespace solver
}  // namespace leonhard
