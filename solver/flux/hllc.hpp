// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/low_mach.hpp"
#include "leonhard/solver/flux/roe.hpp"

// The flux of Harten, Lax and van Leer with the contact wave restored (E. F. Toro, M. Spruce and W. Speares, Shock
// Waves 4, 1994).

namespace leonhard::solver {

/// The flux between one side's outer wave and the contact wave.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> hllc_star_flux(double gamma, const Primitive<dim, T>& w,
                                                  const Vector<dim, T>& n, const T& wave, const T& contact) {
  const T vn = dot(w.velocity, n), change = contact - vn;
  const T ratio = (wave - vn) / (wave - contact);  // of densities
  const Components<dim, T> q = conserved(gamma, w);
  Components<dim, T> f = euler_flux(gamma, w, n);
  f.e[0] += wave * (ratio * w.rho - w.rho);
  for (int i = 0; i < dim; ++i)
    f.e[1 + i] += wave * (ratio * (q.e[1 + i] + w.rho * change * n.e[i]) - q.e[1 + i]);
  f.e[dim + 1] +=
      wave * (ratio * (q.e[dim + 1] + change * (w.rho * contact + w.p / (wave - vn))) - q.e[dim + 1]);
  return f;
}

/// The outer waves are the faster of each side's own and Roe's (B. Einfeldt, SIAM Journal on Numerical Analysis 25,
/// 1988), which keeps density and pressure positive in a step of first order (P. Batten et al., SIAM Journal on
/// Scientific Computing 18, 1997).
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_hllc(const FluxConstants& k, const Primitive<dim, T>& a,
                                             const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  const RoeWaves<dim, T> mean = roe_waves(k, a, b, n, constant<T>(1));
  const T mean_c = 1.0 / mean.inverse_c, vn_a = dot(a.velocity, n), vn_b = dot(b.velocity, n);
  const T wave_a = smaller<T>(vn_a - sound_speed(k.gamma, a), mean.normal_speed - mean_c);
  const T wave_b = larger<T>(vn_b + sound_speed(k.gamma, b), mean.normal_speed + mean_c);
  const T inflow_a = a.rho * (wave_a - vn_a), inflow_b = b.rho * (wave_b - vn_b);
  const T contact = (inflow_b * vn_b - inflow_a * vn_a + (a.p - b.p)) / (inflow_b - inflow_a);
  const Components<dim, T> fa = euler_flux(k.gamma, a, n), fb = euler_flux(k.gamma, b, n),
                           star_a = hllc_star_flux(k.gamma, a, n, wave_a, contact),
                           star_b = hllc_star_flux(k.gamma, b, n, wave_b, contact);
  const T zero = constant<T>(0);
  Components<dim, T> f;
  for (int i = 0; i < dim + 2; ++i)
    f.e[i] = select(contact >= zero, select(wave_a >= zero, fa.e[i], star_a.e[i]),
                    select(wave_b <= zero, fb.e[i], star_b.e[i]));
  return f;
}

/// HLLC between states whose normal velocities have come together (Thornber et al., see low_mach.hpp; here the normal
/// component alone, so that shear stays as it is).
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_hllc_low_mach(const FluxConstants& k, const Primitive<dim, T>& a,
                                                      const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  const T jump = dot(difference(b.velocity, a.velocity), n);
  const T move = 0.5 * (1.0 - low_mach_share(k, a, b)) * jump;
  Primitive<dim, T> near_a = a, near_b = b;
  for (int i = 0; i < dim; ++i) {
    near_a.velocity.e[i] += move * n.e[i];
    near_b.velocity.e[i] -= move * n.e[i];
  }
  return flux_hllc(k, near_a, near_b, n);
}

}  // namespace leonhard::solver
