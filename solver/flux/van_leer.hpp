// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/primitive.hpp"

// B. van Leer's flux vector splitting (Lecture Notes in Physics 170, 1982): each side sends its own flux, smooth through
// sonic points. It smears contacts and shear.

namespace leonhard::solver {

/// What a state sends along the normal; what it sends the other way is that of -n.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> split_van_leer(double gamma, const Primitive<dim, T>& w,
                                                  const Vector<dim, T>& n) {
  const T vn = dot(w.velocity, n), c = sound_speed(gamma, w);
  const T mach = vn / c, up = mach + 1.0;
  const T mass = 0.25 * w.rho * c * up * up, push = (2.0 * c - vn) / gamma;
  const T along = (gamma - 1) * vn + 2.0 * c;
  Components<dim, T> inside;
  inside.e[0] = mass;
  for (int i = 0; i < dim; ++i) inside.e[1 + i] = mass * (w.velocity.e[i] + push * n.e[i]);
  inside.e[dim + 1] =
      mass * (along * along / (2 * (gamma * gamma - 1)) + 0.5 * (dot(w.velocity, w.velocity) - vn * vn));
  const Components<dim, T> all = euler_flux(gamma, w, n);
  const T one = constant<T>(1), zero = constant<T>(0);
  Components<dim, T> f;
  for (int i = 0; i < dim + 2; ++i)
    f.e[i] = select(mach >= one, all.e[i], select(mach <= -one, zero, inside.e[i]));
  return f;
}

template <int dim, class T>
LEONHARD_INLINE Components<dim, T> flux_van_leer(const FluxConstants& k, const Primitive<dim, T>& a,
                                                 const Primitive<dim, T>& b, const Vector<dim, T>& n) {
  Vector<dim, T> back;
  for (int i = 0; i < dim; ++i) back.e[i] = -n.e[i];
  Components<dim, T> f = split_van_leer(k.gamma, a, n);
  const Components<dim, T> from_b = split_van_leer(k.gamma, b, back);
  for (int i = 0; i < dim + 2; ++i) f.e[i] -= from_b.e[i];
  return f;
}

}  // namespace leonhard::solver
