// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/support/lanes.hpp"

// What the fluxes are written in: states, fluxes and normals of the plane (dim = 2) and of space (3), T being double
// (one face) or Lanes (four faces at once).

namespace leonhard::solver {

/// One number an axis.
template <int dim, class T>
struct Vector {
  T e[dim];
};

template <int dim, class T>
LEONHARD_INLINE T dot(const Vector<dim, T>& a, const Vector<dim, T>& b) {
  T sum = a.e[0] * b.e[0];
  for (int i = 1; i < dim; ++i) sum += a.e[i] * b.e[i];
  return sum;
}

template <int dim, class T>
LEONHARD_INLINE Vector<dim, T> difference(const Vector<dim, T>& a, const Vector<dim, T>& b) {
  Vector<dim, T> d;
  for (int i = 0; i < dim; ++i) d.e[i] = a.e[i] - b.e[i];
  return d;
}

/// Primitive variables.
template <int dim, class T>
struct Primitive {
  T rho;
  Vector<dim, T> velocity;
  T p;
};

/// Half the sum of two states.
template <int dim, class T>
LEONHARD_INLINE Primitive<dim, T> mean_state(const Primitive<dim, T>& a, const Primitive<dim, T>& b) {
  Primitive<dim, T> m;
  m.rho = 0.5 * (a.rho + b.rho);
  for (int i = 0; i < dim; ++i) m.velocity.e[i] = 0.5 * (a.velocity.e[i] + b.velocity.e[i]);
  m.p = 0.5 * (a.p + b.p);
  return m;
}

/// A flux, conservative variables or a row or column of a Jacobian: mass, momentum by axis, energy.
template <int dim, class T>
struct Components {
  T e[dim + 2];
};

/// What the fluxes know besides the states.
struct FluxConstants {
  double gamma = 1.4;
  double entropy_fix = 0.05;  ///< Harten's delta as a fraction of |Vn| + c
  double mach = 0.5;          ///< of the free stream
};

/// Enthalpy and kinetic energy of a unit of mass.
template <int dim, class T>
LEONHARD_INLINE T total_enthalpy(double gamma, const Primitive<dim, T>& w) {
  return gamma / (gamma - 1) * w.p / w.rho + 0.5 * dot(w.velocity, w.velocity);
}

template <int dim, class T>
LEONHARD_INLINE T sound_speed(double gamma, const Primitive<dim, T>& w) {
  return root(T(gamma * w.p / w.rho));
}

/// Conservative variables.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> conserved(double gamma, const Primitive<dim, T>& w) {
  Components<dim, T> q;
  q.e[0] = w.rho;
  for (int i = 0; i < dim; ++i) q.e[1 + i] = w.rho * w.velocity.e[i];
  q.e[dim + 1] = w.p / (gamma - 1) + 0.5 * w.rho * dot(w.velocity, w.velocity);
  return q;
}

/// The conservative variables of b less those of a.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> conserved_jump(double gamma, const Primitive<dim, T>& a,
                                                  const Primitive<dim, T>& b) {
  const Components<dim, T> qa = conserved(gamma, a), qb = conserved(gamma, b);
  Components<dim, T> jump;
  for (int i = 0; i < dim + 2; ++i) jump.e[i] = qb.e[i] - qa.e[i];
  return jump;
}

/// The physical flux through a face with unit normal n.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> euler_flux(double gamma, const Primitive<dim, T>& w,
                                              const Vector<dim, T>& n) {
  const T mass = w.rho * dot(w.velocity, n);
  Components<dim, T> f;
  f.e[0] = mass;
  for (int i = 0; i < dim; ++i) f.e[1 + i] = mass * w.velocity.e[i] + w.p * n.e[i];
  f.e[dim + 1] = mass * total_enthalpy(gamma, w);
  return f;
}

/// Half the sum of two fluxes less half a dissipation.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> mean_less(const Components<dim, T>& a, const Components<dim, T>& b,
                                             const Components<dim, T>& dissipation) {
  Components<dim, T> f;
  for (int i = 0; i < dim + 2; ++i) f.e[i] = 0.5 * (a.e[i] + b.e[i] - dissipation.e[i]);
  return f;
}

}  // namespace leonhard::solver
