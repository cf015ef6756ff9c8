// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "leonhard/solver/axes.hpp"
#include "leonhard/solver/flux/viscous.hpp"
#include "leonhard/solver/problem.hpp"

// A smooth field and the source that makes it a solution (P. J. Roache, Journal of Fluids Engineering 124, 2002).

namespace leonhard::test {

template <int dim>
struct Manufactured {
  static constexpr std::size_t n = dim + 2;
  solver::ViscousConstants viscous{};  ///< viscosity 0: the Euler equations

  using Point = typename Simplex<dim>::Point;
  using Axes = solver::Axes<dim>;

  /// Variable number i (rho, velocity, p) at x: a mean and a wave of its own.
  static double value(std::size_t i, const Axes& x) { return mean(i) + size(i) * std::sin(phase(i, x)); }
  static Axes gradient(std::size_t i, const Axes& x) {
    Axes g;
    for (std::size_t j = 0; j < dim; ++j) g[j] = size(i) * wave(i, j) * std::cos(phase(i, x));
    return g;
  }
  static State<dim> state(const Point& at) {
    const Axes x = solver::axes(at);
    Axes velocity;
    for (std::size_t j = 0; j < dim; ++j) velocity[j] = value(1 + j, x);
    return solver::state_with(value(0, x), velocity, value(n - 1, x));
  }

  /// The flux along an axis.
  [[nodiscard]] std::array<double, n> flux(const Axes& x, std::size_t axis) const {
    solver::Primitive<dim, double> w{value(0, x), {}, value(n - 1, x)};
    solver::ViscousGradient<dim, double> g;
    const Axes by_rho = gradient(0, x), by_p = gradient(n - 1, x);
    solver::Vector<dim, double> normal{};
    normal.e[axis] = 1;
    for (std::size_t i = 0; i < dim; ++i) {
      w.velocity.e[i] = value(1 + i, x);
      const Axes by = gradient(1 + i, x);
      for (std::size_t j = 0; j < dim; ++j) g.velocity[i].e[j] = by[j];
      g.temperature.e[i] = viscous.gamma * (by_p[i] - w.p / w.rho * by_rho[i]) / w.rho;
    }
    const auto f = solver::euler_flux(viscous.gamma, w, normal);
    const auto friction = solver::viscous_flux(viscous, w, g, normal);
    std::array<double, n> sum;
    for (std::size_t i = 0; i < n; ++i) sum[i] = f.e[i] + (viscous.viscosity > 0 ? friction.e[i] : 0);
    return sum;
  }

  /// The divergence of the flux, by central differences of fourth order.
  [[nodiscard]] std::array<double, n> source(const Point& at) const {
    constexpr double h = 1e-3;
    std::array<double, n> sum{};
    for (std::size_t axis = 0; axis < dim; ++axis) {
      const auto beside = [&](double steps) {
        Axes x = solver::axes(at);
        x[axis] += steps * h;
        return flux(x, axis);
      };
      const auto far = beside(2), near = beside(1), minus_near = beside(-1), minus_far = beside(-2);
      for (std::size_t i = 0; i < n; ++i)
        sum[i] += (8 * (near[i] - minus_near[i]) - (far[i] - minus_far[i])) / (12 * h);
    }
    return sum;
  }

 private:
  static double mean(std::size_t i) { return i == 0 ? 1.0 : i == n - 1 ? 1 / 1.4 : i == 1 ? 0.5 : 0.2 / static_cast<double>(i); }
  static double size(std::size_t i) { return i == 0 || i == n - 1 ? 0.08 : 0.06; }
  static double wave(std::size_t i, std::size_t j) { return 1.7 + 0.6 * static_cast<double>((2 * i + 3 * j) % 5); }
  static double phase(std::size_t i, const Axes& x) {
    double sum = 0.4 * static_cast<double>(i);
    for (std::size_t j = 0; j < dim; ++j) sum += wave(i, j) * x[j];
    return sum;
  }
};

}  // namespace leonhard::test
