// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "leonhard/kernel/point.hpp"

namespace leonhard {

/// A calorically perfect gas. Everything is non-dimensional: far upstream rho = 1, speed of sound = 1, hence
/// p = 1/gamma and |V| = the Mach number; the temperature is that of c^2, T = gamma p / rho, 1 far upstream.
struct Gas {
  double gamma = 1.4;  ///< ratio of specific heats, > 1
};

/// What makes the flow one of the Navier-Stokes equations: laminar viscosity and conduction of heat.
struct Viscosity {
  double reynolds = 1e4;  ///< rho |V| length / viscosity of the undisturbed flow, > 0; the length is the reference's
  double prandtl = 0.72;  ///< > 0
  /// Sutherland's temperature over that of the undisturbed flow (air: 110.4 K over 288.15 K); below 0: the viscosity is
  /// constant.
  double sutherland = 110.4 / 288.15;
};

/// The undisturbed flow. In the plane alpha is counter-clockwise from the x axis. In space x points downstream, z up and y
/// along the span: the direction is (cos alpha cos beta, sin beta, sin alpha cos beta).
struct FreeStream {
  double mach = 0.5;     ///< > 0
  double alpha_rad = 0;  ///< angle of attack
  double beta_rad = 0;   ///< sideslip; space only
};

/// Primitive variables at a point of the plane (dim 2) or of space (3).
template <int dim>
struct State;

/// 32-byte aligned so that one state is one vector register.
template <>
struct alignas(32) State<2> {
  double rho{}, u{}, v{}, p{};
  friend constexpr bool operator==(const State&, const State&) = default;
};

template <>
struct State<3> {
  double rho{}, u{}, v{}, w{}, p{};
  friend constexpr bool operator==(const State&, const State&) = default;
};

namespace solver {

/// Conservative variables (rho, rho V, rho E), or a flux or residual of them.
template <int dim>
using Conserved = std::array<double, dim + 2>;

/// One number an axis.
template <int dim>
using Axes = std::array<double, dim>;

[[nodiscard]] inline Axes<2> velocity(const State<2>& w) { return {w.u, w.v}; }
[[nodiscard]] inline Axes<3> velocity(const State<3>& w) { return {w.u, w.v, w.w}; }

[[nodiscard]] inline State<2> state_with(double rho, const Axes<2>& velocity, double p) {
  return {rho, velocity[0], velocity[1], p};
}
[[nodiscard]] inline State<3> state_with(double rho, const Axes<3>& velocity, double p) {
  return {rho, velocity[0], velocity[1], velocity[2], p};
}

template <std::size_t dim>
[[nodiscard]] double dot(const std::array<double, dim>& a, const std::array<double, dim>& b) {
  double sum = a[0] * b[0];
  for (std::size_t i = 1; i < dim; ++i) sum += a[i] * b[i];
  return sum;
}

/// The unit vector along which the undisturbed flow goes.
template <int dim>
[[nodiscard]] Axes<dim> direction(FreeStream free) {
  if constexpr (dim == 2)
    return {std::cos(free.alpha_rad), std::sin(free.alpha_rad)};
  else
    return {std::cos(free.alpha_rad) * std::cos(free.beta_rad), std::sin(free.beta_rad),
            std::sin(free.alpha_rad) * std::cos(free.beta_rad)};
}

/// The state far upstream. Pure.
template <int dim>
[[nodiscard]] State<dim> free_stream_state(Gas gas, FreeStream free) {
  Axes<dim> velocity = direction<dim>(free);
  for (double& component : velocity) component *= free.mach;
  return state_with(1.0, velocity, 1.0 / gas.gamma);
}

/// rho > 0, p > 0 and all finite.
template <int dim>
[[nodiscard]] bool is_physical(const State<dim>& w) {
  const Axes<dim> v = velocity(w);
  return std::ranges::all_of(v, [](double x) { return std::isfinite(x); }) && w.rho > 0 && w.p > 0 &&
         std::isfinite(w.rho) && std::isfinite(w.p);
}

template <int dim>
[[nodiscard]] Conserved<dim> conserved_of(Gas gas, const State<dim>& w) {
  const Axes<dim> v = velocity(w);
  Conserved<dim> q;
  q[0] = w.rho;
  for (std::size_t i = 0; i < dim; ++i) q[1 + i] = w.rho * v[i];
  q[dim + 1] = w.p / (gas.gamma - 1) + 0.5 * w.rho * dot(v, v);
  return q;
}

template <int dim>
[[nodiscard]] State<dim> state_of(Gas gas, const double* q) {
  Axes<dim> v;
  double kinetic = 0;
  for (std::size_t i = 0; i < dim; ++i) v[i] = q[1 + i] / q[0], kinetic += q[1 + i] * v[i];
  return state_with(q[0], v, (gas.gamma - 1) * (q[dim + 1] - 0.5 * kinetic));
}

[[nodiscard]] inline State<2> state_of(Gas gas, const Conserved<2>& q) { return state_of<2>(gas, q.data()); }
[[nodiscard]] inline State<3> state_of(Gas gas, const Conserved<3>& q) { return state_of<3>(gas, q.data()); }

template <int dim>
[[nodiscard]] double sound_speed(Gas gas, const State<dim>& w) {
  return std::sqrt(gas.gamma * w.p / w.rho);
}

template <int dim>
[[nodiscard]] double mach_number(Gas gas, const State<dim>& w) {
  const Axes<dim> v = velocity(w);
  return std::sqrt(dot(v, v)) / sound_speed(gas, w);
}

/// (p - p_inf) / (rho_inf |V_inf|^2 / 2).
[[nodiscard]] inline double pressure_coefficient(Gas gas, FreeStream free, double p) {
  return (p - 1.0 / gas.gamma) / (0.5 * free.mach * free.mach);
}

/// Total pressure over that of the free stream; 1 where the flow is isentropic and uniform upstream.
template <int dim>
[[nodiscard]] double total_pressure_ratio(Gas gas, FreeStream free, const State<dim>& w) {
  const auto head = [&](double m2) {
    return std::pow(1 + 0.5 * (gas.gamma - 1) * m2, gas.gamma / (gas.gamma - 1));
  };
  const double m = mach_number(gas, w);
  return w.p * gas.gamma * head(m * m) / head(free.mach * free.mach);
}

/// p / rho^gamma over that of the free stream.
template <int dim>
[[nodiscard]] double entropy_ratio(Gas gas, const State<dim>& w) {
  return gas.gamma * w.p / std::pow(w.rho, gas.gamma);
}

/// Viscosity at a temperature, in units of rho_inf c_inf length.
[[nodiscard]] inline double viscosity_at(const Viscosity& viscosity, FreeStream free, double length, double temperature) {
  const double far = free.mach * length / viscosity.reynolds, s = viscosity.sutherland;
  return s < 0 ? far : far * temperature * std::sqrt(temperature) * (1 + s) / (temperature + s);
}

}  // namespace solver
}  // namespace leonhard
