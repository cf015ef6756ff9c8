// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/sweep/lanes.hpp"

// Roe's flux and the Jacobians for the implicit operator: pure functions of two states and a unit normal. T is
// double (one face) or Lanes (four faces at once).

namespace leonhard::solver {

/// Primitive variables, one face or four.
template <class T>
struct Primitive {
  T rho, u, v, p;
};

/// A flux (mass, x and y momentum, energy) or a row or column of a Jacobian.
template <class T>
struct Four {
  T e[4];
};

/// A 4 x 4 matrix by conservative variables; m[row][column].
template <class T>
struct Block {
  T m[4][4];
};

/// Constants of the flux; entropy_fix is Harten's delta as a fraction of |Vn| + c.
struct RoeConstants {
  double gamma = 1.4;
  double entropy_fix = 0.05;
};

/// What Roe's dissipation is made of: |A| dU = slow dU + (d_u) (1, u, v, H) + (d_n) (0, nx, ny, Vn).
template <class T>
struct RoeWaves {
  T u, v, enthalpy, normal_speed, density, inverse_c;
  T slow;       ///< |Vn|
  T mean_fast;  ///< (|Vn + c| + |Vn - c|) / 2 - |Vn|
  T diff_fast;  ///< (|Vn + c| - |Vn - c|) / 2
};

/// Harten's entropy fix (Journal of Computational Physics 49, 1983): |x| made smooth and bounded below near 0.
template <class T>
LEONHARD_INLINE T fixed_magnitude(const T& x, const T& delta) {
  const T size = magnitude<T>(x);
  return select(size < delta, T(0.5 * (x * x / delta + delta)), size);
}

/// Roe's average (P. L. Roe, Journal of Computational Physics 43, 1981) and the absolute wave speeds.
template <class T>
LEONHARD_INLINE RoeWaves<T> roe_waves(const RoeConstants& k, const Primitive<T>& a, const Primitive<T>& b,
                                      const T& nx, const T& ny) {
  const double gas = k.gamma / (k.gamma - 1);
  const T ratio = root(T(b.rho / a.rho));
  const T share_a = 1.0 / (1.0 + ratio), share_b = ratio * share_a;
  const T enthalpy_a = gas * a.p / a.rho + 0.5 * (a.u * a.u + a.v * a.v);
  const T enthalpy_b = gas * b.p / b.rho + 0.5 * (b.u * b.u + b.v * b.v);
  RoeWaves<T> w;
  w.density = ratio * a.rho;
  w.u = share_a * a.u + share_b * b.u;
  w.v = share_a * a.v + share_b * b.v;
  w.enthalpy = share_a * enthalpy_a + share_b * enthalpy_b;
  w.normal_speed = w.u * nx + w.v * ny;
  const T c = root(T((k.gamma - 1) * (w.enthalpy - 0.5 * (w.u * w.u + w.v * w.v))));
  w.inverse_c = 1.0 / c;
  const T delta = k.entropy_fix * (magnitude<T>(w.normal_speed) + c) + 1e-300;
  w.slow = fixed_magnitude<T>(w.normal_speed, delta);
  const T plus = fixed_magnitude<T>(w.normal_speed + c, delta),
          minus = fixed_magnitude<T>(w.normal_speed - c, delta);
  w.mean_fast = 0.5 * (plus + minus) - w.slow;
  w.diff_fast = 0.5 * (plus - minus);
  return w;
}

/// The physical flux through a face with unit normal (nx, ny).
template <class T>
LEONHARD_INLINE Four<T> euler_flux(double gamma, const Primitive<T>& w, const T& nx, const T& ny) {
  const T mass = w.rho * (w.u * nx + w.v * ny);
  const T enthalpy = gamma / (gamma - 1) * w.p / w.rho + 0.5 * (w.u * w.u + w.v * w.v);
  return {{mass, mass * w.u + w.p * nx, mass * w.v + w.p * ny, mass * enthalpy}};
}

template <class T>
LEONHARD_INLINE Four<T> conserved_lanes(double gamma, const Primitive<T>& w) {
  return {{w.rho, w.rho * w.u, w.rho * w.v, w.p / (gamma - 1) + 0.5 * w.rho * (w.u * w.u + w.v * w.v)}};
}

/// Roe's flux from a to b per unit length of face; the unit normal points from a to b.
/// The entropy fix acts on all three speeds: on Vn +- c it forbids expansion shocks, on Vn it keeps a little
/// dissipation where the flow is along the face.
template <class T>
LEONHARD_INLINE Four<T> flux_roe(const RoeConstants& k, const Primitive<T>& a, const Primitive<T>& b,
                                 const T& nx, const T& ny) {
  const RoeWaves<T> w = roe_waves<T>(k, a, b, nx, ny);
  const T jump_p = b.p - a.p;
  const T jump_n = w.density * ((b.u - a.u) * nx + (b.v - a.v) * ny);
  const T along_u = (w.mean_fast * jump_p * w.inverse_c + w.diff_fast * jump_n) * w.inverse_c;
  const T along_n = w.mean_fast * jump_n + w.diff_fast * jump_p * w.inverse_c;
  const Four<T> fa = euler_flux<T>(k.gamma, a, nx, ny), fb = euler_flux<T>(k.gamma, b, nx, ny);
  const Four<T> qa = conserved_lanes<T>(k.gamma, a), qb = conserved_lanes<T>(k.gamma, b);
  const T to[4] = {along_u, along_u * w.u + along_n * nx, along_u * w.v + along_n * ny,
                   along_u * w.enthalpy + along_n * w.normal_speed};
  Four<T> f;
  for (int i = 0; i < 4; ++i) f.e[i] = 0.5 * (fa.e[i] + fb.e[i] - (w.slow * (qb.e[i] - qa.e[i]) + to[i]));
  return f;
}

/// speed I + (1, u, v, H) x across + (0, nx, ny, Vn) x along, scaled: the shape of A and of Roe's |A|.
template <class T>
struct RankTwo {
  T u, v, enthalpy, nx, ny, normal_speed, speed;
  Four<T> across, along;

  template <class Scale>
  [[gnu::always_inline]] inline void add_to(Block<T>& block, const Scale& scale) const {
    const T left[4] = {constant<T>(1), u, v, enthalpy};
    const T right[4] = {constant<T>(0), nx, ny, normal_speed};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) block.m[i][j] += scale * (left[i] * across.e[j] + right[i] * along.e[j]);
      block.m[i][i] += scale * speed;
    }
  }
};

/// Derivative of pressure by the conservative variables at velocity (u, v).
template <class T>
LEONHARD_INLINE Four<T> pressure_gradient(double gamma, const T& u, const T& v) {
  const double g = gamma - 1;
  return {{0.5 * g * (u * u + v * v), -g * u, -g * v, constant<T>(g)}};
}

/// The exact Jacobian of euler_flux.
template <class T>
LEONHARD_INLINE RankTwo<T> euler_jacobian(double gamma, const Primitive<T>& w, const T& nx, const T& ny) {
  const T vn = w.u * nx + w.v * ny;
  const T enthalpy = gamma / (gamma - 1) * w.p / w.rho + 0.5 * (w.u * w.u + w.v * w.v);
  return {w.u,
          w.v,
          enthalpy,
          nx,
          ny,
          vn,
          vn,
          {{-vn, nx, ny, constant<T>(0)}},
          pressure_gradient<T>(gamma, w.u, w.v)};
}

/// Roe's |A| between a and b.
template <class T>
LEONHARD_INLINE RankTwo<T> roe_dissipation(const RoeConstants& k, const Primitive<T>& a,
                                           const Primitive<T>& b, const T& nx, const T& ny) {
  const RoeWaves<T> w = roe_waves<T>(k, a, b, nx, ny);
  const Four<T> by_p = pressure_gradient<T>(k.gamma, w.u, w.v);
  const T by_n[4] = {-w.normal_speed, nx, ny, constant<T>(0)};
  RankTwo<T> d{w.u, w.v, w.enthalpy, nx, ny, w.normal_speed, w.slow, {}, {}};
  for (int j = 0; j < 4; ++j) {
    d.across.e[j] = (w.mean_fast * by_p.e[j] * w.inverse_c + w.diff_fast * by_n[j]) * w.inverse_c;
    d.along.e[j] = w.mean_fast * by_n[j] + w.diff_fast * by_p.e[j] * w.inverse_c;
  }
  return d;
}

/// Jacobians of flux_roe by the conservative variables of a and of b, with Roe's matrix held fixed
/// (T. J. Barth, AIAA 87-0595): (A(a) + |A|) / 2 and (A(b) - |A|) / 2.
template <class T>
LEONHARD_INLINE void flux_roe_jacobians(const RoeConstants& k, const Primitive<T>& a, const Primitive<T>& b,
                                        const T& nx, const T& ny, Block<T>& by_a, Block<T>& by_b) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) by_a.m[i][j] = by_b.m[i][j] = constant<T>(0);
  const RankTwo<T> dissipation = roe_dissipation<T>(k, a, b, nx, ny);
  euler_jacobian<T>(k.gamma, a, nx, ny).add_to(by_a, 0.5);
  euler_jacobian<T>(k.gamma, b, nx, ny).add_to(by_b, 0.5);
  dissipation.add_to(by_a, 0.5);
  dissipation.add_to(by_b, -0.5);
}

}  // namespace leonhard::solver
