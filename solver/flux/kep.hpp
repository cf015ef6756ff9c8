// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/roe.hpp"
#include "leonhard/solver/flux/rusanov.hpp"

// The kinetic-energy-preserving, entropy-conservative central flux and entropy-stable dissipation for it:
// P. Chandrashekar, Communications in Computational Physics 14, 2013. beta = rho / (2 p).

namespace leonhard::solver {

/// The logarithmic mean (x - y) / log(x / y) of two positive numbers, without a logarithm: that of x and y is that of
/// their square roots times the mean of these (B. C. Carlson, American Mathematical Monthly 79, 1972); after
/// four roots log is a short series. To rounding for ratios up to 1000, to 1e-9 up to 10^6.
template <class T>
LEONHARD_INLINE T logarithmic_mean(const T& x, const T& y) {
  T ratio = x / y, mean = y;
  for (int i = 0; i < 4; ++i) {
    ratio = root(ratio);
    mean *= 0.5 * (ratio + 1.0);
  }
  const T f = (ratio - 1.0) / (ratio + 1.0), f2 = f * f;
  T series = constant<T>(1.0 / 19);  // atanh(f) / f
  for (int i = 17; i > 0; i -= 2) series = series * f2 + 1.0 / i;
  return mean * 0.5 * (ratio + 1.0) / series;
}

/// What the central flux and its dissipation are made of.
template <int dim, class T>
struct KepMeans {
  Vector<dim, T> velocity, jump_velocity;
  T rho, rho_log, beta, beta_log, jump_rho, jump_beta;
};

template <int dim, class T>
LEONHARD_INLINE KepMeans<dim, T> kep_means(const Primitive<dim, T>& a, const Primitive<dim, T>& b) {
  const T beta_a = a.rho / (2.0 * a.p), beta_b = b.rho / (2.0 * b.p);
  KepMeans<dim, T> m;
  for (int i = 0; i < dim; ++i) m.velocity.e[i] = 0.5 * (a.velocity.e[i] + b.velocity.e[i]);
  m.jump_velocity = difference(b.velocity, a.velocity);
  m.rho = 0.5 * (a.rho + b.rho), m.rho_log = logarithmic_mean(a.rho, b.rho), m.jump_rho = b.rho - a.rho;
  m.beta = 0.5 * (beta_a + beta_b), m.beta_log = logarithmic_mean(beta_a, beta_b);
  m.jump_beta = beta_b - beta_a;
  return m;
}

/// His KEPEC flux: momentum is carried as the mean velocity times the mass flux (A. Jameson, Journal
/// of Scientific Computing 34, 2008), and no entropy is made or lost.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> kep_central(double gamma, const KepMeans<dim, T>& m,
                                               const Vector<dim, T>& n) {
  const T mass = m.rho_log * dot(m.velocity, n), p = m.rho / (2.0 * m.beta);
  // The mean of |V|^2 is |V|^2 of the mean and a quarter of the jump's.
  const T mean_square = dot(m.velocity, m.velocity) + 0.25 * dot(m.jump_velocity, m.jump_velocity);
  Components<dim, T> f;
  f.e[0] = mass;
  f.e[dim + 1] = (0.5 / (gamma - 1) / m.beta_log - 0.5 * mean_square) * mass;
  for (int i = 0; i < dim; ++i) {
    f.e[1 + i] = mass * m.velocity.e[i] + p * n.e[i];
    f.e[dim + 1] += f.e[1 + i] * m.velocity.e[i];
  }
  return f;
}

/// The jump of the conservative variables as the jump of the entropy variables brings it about in a mean state of
/// density rho_log, pressure rho_log / (2 beta_log) and mean velocity. Any positive definite matrix in front
/// of it makes entropy; in a contact at rest both pressure and velocity have no jump, so that |A| leaves it alone.
template <int dim, class T>
struct KepJump {
  Components<dim, T> conserved;
  T p, n;  ///< of pressure; of the normal velocity times density
};

template <int dim, class T>
LEONHARD_INLINE KepJump<dim, T> kep_jump(double gamma, const KepMeans<dim, T>& m, const Vector<dim, T>& n) {
  const T extra = 0.25 * dot(m.jump_velocity, m.jump_velocity) * m.jump_beta;
  const T share = m.rho_log * m.beta / m.beta_log, p = m.rho_log / (2.0 * m.beta_log);
  KepJump<dim, T> jump;
  jump.p = p * (m.jump_rho / m.rho_log - m.jump_beta / m.beta_log - extra);
  jump.n = share * dot(m.jump_velocity, n);
  const T rho = m.jump_rho - m.rho_log * extra;
  jump.conserved.e[0] = rho;
  jump.conserved.e[dim + 1] = jump.p / (gamma - 1) - 0.5 * dot(m.velocity, m.velocity) * rho;
  for (int i = 0; i < dim; ++i) {
    const T momentum = m.velocity.e[i] * rho + share * m.jump_velocity.e[i];
    jump.conserved.e[1 + i] = momentum;
    jump.conserved.e[dim + 1] += m.velocity.e[i] * momentum;
  }
  return jump;
}

/// With the fastest wave's speed as dissipation.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_kep_scalar(const FluxConstants& k, const Primitive<dim, T>& a,
                                                   const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  const KepMeans<dim, T> m = kep_means(a, b);
  const T speed = fastest_wave(k.gamma, a, b, n);
  const Components<dim, T> jump = kep_jump(k.gamma, m, n).conserved;
  Components<dim, T> f = kep_central(k.gamma, m, n);
  for (int i = 0; i < dim + 2; ++i) f.e[i] -= 0.5 * speed * jump.e[i];
  return f;
}

/// With each wave's own speed as dissipation.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_kep_matrix(const FluxConstants& k, const Primitive<dim, T>& a,
                                                   const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  const KepMeans<dim, T> m = kep_means(a, b);
  const T c2 = k.gamma / (2.0 * m.beta_log);
  RoeWaves<dim, T> w;
  w.velocity = m.velocity;
  w.enthalpy = c2 / (k.gamma - 1) + 0.5 * dot(m.velocity, m.velocity);
  w.normal_speed = dot(m.velocity, n);
  w.density = m.rho_log;
  set_speeds(k, T(root(c2)), constant<T>(1), w);
  const KepJump<dim, T> jump = kep_jump(k.gamma, m, n);
  const Components<dim, T> dissipation = roe_dissipation(w, n, jump.conserved, jump.p, jump.n);
  Components<dim, T> f = kep_central(k.gamma, m, n);
  for (int i = 0; i < dim + 2; ++i) f.e[i] -= 0.5 * dissipation.e[i];
  return f;
}

}  // namespace leonhard::solver
