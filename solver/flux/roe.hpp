// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/low_mach.hpp"
#include "leonhard/solver/flux/primitive.hpp"

// P. L. Roe's flux (Journal of Computational Physics 43, 1981) with Harten's entropy fix.

namespace leonhard::solver {

/// Roe's average and the absolute wave speeds.
template <int dim, class T>
struct RoeWaves {
  Vector<dim, T> velocity;
  T enthalpy, normal_speed, density, inverse_c;
  T slow;       ///< |Vn|
  T mean_fast;  ///< (|Vn + c| + |Vn - c|) / 2 - |Vn|
  T diff_fast;  ///< (|Vn + c| - |Vn - c|) / 2
  T share;      ///< of the normal velocity's jump that the fast waves see
};

/// Harten's entropy fix (Journal of Computational Physics 49, 1983): |x| made smooth and bounded below near 0.
template <class T>
LEONHARD_INLINE T fixed_magnitude(const T& x, const T& delta) {
  const T size = magnitude<T>(x);
  return select(size < delta, T(0.5 * (x * x / delta + delta)), size);
}

/// The wave speeds of a state whose velocity, enthalpy, normal speed and density are set, and its speed of sound c.
/// share  what is left of the entropy fix on the slow wave, and of the normal velocity's jump: see low_mach.hpp
template <int dim, class T>
LEONHARD_INLINE void set_speeds(const FluxConstants& k, const T& c, const T& share, RoeWaves<dim, T>& w) {
  w.inverse_c = 1.0 / c;
  w.share = share;
  const T delta = k.entropy_fix * (magnitude<T>(w.normal_speed) + c) + 1e-300;
  w.slow = fixed_magnitude<T>(w.normal_speed, share * delta);
  const T plus = fixed_magnitude<T>(w.normal_speed + c, delta),
          minus = fixed_magnitude<T>(w.normal_speed - c, delta);
  w.mean_fast = 0.5 * (plus + minus) - w.slow;
  w.diff_fast = 0.5 * (plus - minus);
}

template <int dim, class T>
LEONHARD_INLINE RoeWaves<dim, T> roe_waves(const FluxConstants& k, const Primitive<dim, T>& a,
                                           const Primitive<dim, T>& b, const Vector<dim, T>& n,
                                           const T& share) {
  const T ratio = root(T(b.rho / a.rho));
  const T share_a = 1.0 / (1.0 + ratio), share_b = ratio * share_a;
  RoeWaves<dim, T> w;
  w.density = ratio * a.rho;
  for (int i = 0; i < dim; ++i) w.velocity.e[i] = share_a * a.velocity.e[i] + share_b * b.velocity.e[i];
  w.enthalpy = share_a * total_enthalpy(k.gamma, a) + share_b * total_enthalpy(k.gamma, b);
  w.normal_speed = dot(w.velocity, n);
  set_speeds(k, T(root(T((k.gamma - 1) * (w.enthalpy - 0.5 * dot(w.velocity, w.velocity))))), share, w);
  return w;
}

/// |A| times a jump: slow jump + along_u (1, V, H) + along_n (0, n, Vn).
///
/// jump    of the conservative variables
/// jump_p  the jump of pressure that it brings
/// jump_n  density times the jump of the normal velocity that it brings
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> roe_dissipation(const RoeWaves<dim, T>& w, const Vector<dim, T>& n,
                                                   const Components<dim, T>& jump, const T& jump_p,
                                                   const T& jump_n) {
  const T kept_n = w.share * jump_n;
  const T along_u = (w.mean_fast * jump_p * w.inverse_c + w.diff_fast * kept_n) * w.inverse_c;
  const T along_n = w.mean_fast * kept_n + w.diff_fast * jump_p * w.inverse_c;
  Components<dim, T> d;
  d.e[0] = w.slow * jump.e[0] + along_u;
  for (int i = 0; i < dim; ++i)
    d.e[1 + i] = w.slow * jump.e[1 + i] + (along_u * w.velocity.e[i] + along_n * n.e[i]);
  d.e[dim + 1] = w.slow * jump.e[dim + 1] + (along_u * w.enthalpy + along_n * w.normal_speed);
  return d;
}

/// The physical fluxes' mean less half of |A| times the jump.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_of_waves(const FluxConstants& k, const Primitive<dim, T>& a,
                                                 const Primitive<dim, T>& b, const Vector<dim, T>& n,
                                                 const RoeWaves<dim, T>& w) {
  const T jump_n = w.density * dot(difference(b.velocity, a.velocity), n);
  return mean_less(euler_flux(k.gamma, a, n), euler_flux(k.gamma, b, n),
                   roe_dissipation(w, n, conserved_jump(k.gamma, a, b), T(b.p - a.p), jump_n));
}

/// Roe's flux from a to b per unit of the face; the unit normal n points from a to b.
/// The entropy fix acts on all three speeds: on Vn +- c it forbids expansion shocks, on Vn it keeps a little
/// dissipation where the flow is along the face.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_roe(const FluxConstants& k, const Primitive<dim, T>& a,
                                            const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  return flux_of_waves(k, a, b, n, roe_waves(k, a, b, n, constant<T>(1)));
}

/// Roe's flux for small Mach numbers too: see low_mach.hpp.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_roe_low_mach(const FluxConstants& k, const Primitive<dim, T>& a,
                                                     const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  return flux_of_waves(k, a, b, n, roe_waves(k, a, b, n, low_mach_share(k, a, b)));
}

}  // namespace leonhard::solver
