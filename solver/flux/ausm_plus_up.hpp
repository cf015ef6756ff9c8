// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/primitive.hpp"

// AUSM+-up for all speeds: M.-S. Liou, Journal of Computational Physics 214, 2006.

namespace leonhard::solver {

/// The part of a Mach number that runs along the normal: equation (20), beta = 1/8. The other is -(-m).
template <class T>
LEONHARD_INLINE T split_mach(const T& m) {
  const T up = m + 1.0, down = m - 1.0;
  const T inside = 0.25 * up * up * (1.0 + 0.5 * down * down);
  return select(magnitude<T>(m) < constant<T>(1), inside, larger<T>(m, constant<T>(0)));
}

/// The share of a side's pressure that acts along the normal: equation (24). The other side's is that of -m.
template <class T>
LEONHARD_INLINE T split_pressure(const T& m, const T& alpha) {
  const T up = m + 1.0, down = m - 1.0;
  const T inside = 0.25 * up * up * (2.0 - m + 4.0 * alpha * m * down * down);
  const T outside = select(m > constant<T>(0), constant<T>(1), constant<T>(0));
  return select(magnitude<T>(m) < constant<T>(1), inside, outside);
}

/// The speed of sound that one side brings to the face.
template <int dim, class T>
LEONHARD_INLINE T critical_speed(double gamma, const Primitive<dim, T>& w, const T& outwards) {
  const T critical2 = 2 * (gamma - 1) / (gamma + 1) * total_enthalpy(gamma, w);
  return critical2 / larger<T>(root(critical2), outwards);
}

/// K_p = 1/4, K_u = 3/4, sigma = 1; the Mach number of the free stream bounds the scaling from below (M_co there).
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_ausm_plus_up(const FluxConstants& k, const Primitive<dim, T>& a,
                                                     const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  const T one = constant<T>(1), zero = constant<T>(0);
  const T vn_a = dot(a.velocity, n), vn_b = dot(b.velocity, n);
  const T c = smaller<T>(critical_speed(k.gamma, a, vn_a), critical_speed(k.gamma, b, T(-vn_b)));
  const T mach_a = vn_a / c, mach_b = vn_b / c;
  const T mean2 = 0.5 * (mach_a * mach_a + mach_b * mach_b);
  const T reference = root(smaller<T>(one, larger<T>(mean2, constant<T>(k.mach * k.mach))));
  const T scale = reference * (2.0 - reference);
  const T alpha = 3.0 / 16 * (5.0 * scale * scale - 4.0);
  const T mean_rho = 0.5 * (a.rho + b.rho);
  const T mach = split_mach(mach_a) - split_mach(T(-mach_b)) -
                 0.25 / scale * larger<T>(1.0 - mean2, zero) * (b.p - a.p) / (mean_rho * c * c);
  const T share_a = split_pressure(mach_a, alpha), share_b = split_pressure(T(-mach_b), alpha);
  const T p = share_a * a.p + share_b * b.p - 1.5 * share_a * share_b * mean_rho * scale * c * (vn_b - vn_a);
  const T mass_a = c * larger<T>(mach, zero) * a.rho, mass_b = c * smaller<T>(mach, zero) * b.rho;
  Components<dim, T> f;
  f.e[0] = mass_a + mass_b;
  for (int i = 0; i < dim; ++i) f.e[1 + i] = mass_a * a.velocity.e[i] + mass_b * b.velocity.e[i] + p * n.e[i];
  f.e[dim + 1] = mass_a * total_enthalpy(k.gamma, a) + mass_b * total_enthalpy(k.gamma, b);
  return f;
}

}  // namespace leonhard::solver
