// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/primitive.hpp"

// V. V. Rusanov's flux (USSR Computational Mathematics and Mathematical Physics 1, 1962), the local form of Lax and
// Friedrichs': the most dissipative and the most robust.

namespace leonhard::solver {

/// The greater |Vn| + c of two states.
template <int dim, class T>
LEONHARD_INLINE T fastest_wave(double gamma, const Primitive<dim, T>& a, const Primitive<dim, T>& b,
                               const Vector<dim, T>& n) {
  return larger<T>(magnitude<T>(dot(a.velocity, n)) + sound_speed(gamma, a),
                   magnitude<T>(dot(b.velocity, n)) + sound_speed(gamma, b));
}

/// A step of first order keeps density and pressure positive (B. Perthame and C.-W. Shu, Numerische Mathematik 73, 1996).
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_rusanov(const FluxConstants& k, const Primitive<dim, T>& a,
                                                const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  const T speed = fastest_wave(k.gamma, a, b, n);
  Components<dim, T> dissipation = conserved_jump(k.gamma, a, b);
  for (T& component : dissipation.e) component *= speed;
  return mean_less(euler_flux(k.gamma, a, n), euler_flux(k.gamma, b, n), dissipation);
}

}  // namespace leonhard::solver
