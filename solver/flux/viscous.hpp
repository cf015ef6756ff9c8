// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/jacobian.hpp"
#include "leonhard/solver/flux/primitive.hpp"
#include "leonhard/solver/flux/viscous_constants.hpp"

// Friction and conduction of heat between two control volumes.
//
// The gradient on the face is the mean of the two vertices' gradients, corrected along the face's normal n by the jump
// between the values that these gradients carry from both ends to the edge's midpoint:
//   grad = mean + damping / (d . n) (b - a - mean . d) n,   d the edge from a to b
// (H. Nishikawa, AIAA 2010-5093). Damping 1 takes the derivative along an edge that is normal to its face from the two ends alone:
// exact for quadratic functions on regular meshes, up to the wall, where the gradients are one-sided. 4/3, which is of fourth order
// inside, is not; its errors on irregular meshes are a quarter less on triangles and a third more on tetrahedra. d . n is positive in
// every median dual of simplices.

namespace leonhard::solver {

/// Temperature as the square of the speed of sound.
template <int dim, class T>
LEONHARD_INLINE T temperature(double gamma, const Primitive<dim, T>& w) {
  return gamma * w.p / w.rho;
}

template <class T>
LEONHARD_INLINE T viscosity(const ViscousConstants& k, const T& temperature) {
  const double s = k.sutherland;
  if (s < 0) return constant<T>(k.viscosity);
  return (k.viscosity * (1 + s)) * temperature * root(temperature) / (temperature + s);
}

/// Gradients of velocity and temperature; velocity[i][j] is the derivative of component i along axis j.
template <int dim, class T>
struct ViscousGradient {
  Vector<dim, T> velocity[dim];
  Vector<dim, T> temperature;
};

/// The viscous flux from a to b per unit of the face: friction and heat, with the sign of a flux that is added to
/// the convective one. `at` is the mean state.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> viscous_flux(const ViscousConstants& k, const Primitive<dim, T>& at,
                                                const ViscousGradient<dim, T>& gradient,
                                                const Vector<dim, T>& n) {
  const T mu = viscosity<T>(k, temperature(k.gamma, at));
  T divergence = gradient.velocity[0].e[0];
  for (int i = 1; i < dim; ++i) divergence += gradient.velocity[i].e[i];
  Components<dim, T> f;
  f.e[0] = constant<T>(0);
  T work = (k.inverse_prandtl / (k.gamma - 1)) * dot(gradient.temperature, n);
  for (int i = 0; i < dim; ++i) {
    T stress = dot(gradient.velocity[i], n) - (2.0 / 3.0) * divergence * n.e[i];
    for (int j = 0; j < dim; ++j) stress += gradient.velocity[j].e[i] * n.e[j];
    f.e[1 + i] = -mu * stress;
    work += stress * at.velocity.e[i];
  }
  f.e[dim + 1] = -mu * work;
  return f;
}

/// mean corrected along the normal by the jump that it does not explain; see above.
/// jump       velocity and temperature of b less those of a
/// d          the edge from a to b
/// share      the damping over d . n
template <int dim, class T>
LEONHARD_INLINE void correct_along_normal(const Vector<dim, T>& jump_velocity, const T& jump_temperature,
                                          const Vector<dim, T>& d, const Vector<dim, T>& n, const T& share,
                                          ViscousGradient<dim, T>& mean) {
  for (int i = 0; i < dim; ++i) {
    const T missing = share * (jump_velocity.e[i] - dot(mean.velocity[i], d));
    for (int j = 0; j < dim; ++j) mean.velocity[i].e[j] += missing * n.e[j];
  }
  const T missing = share * (jump_temperature - dot(mean.temperature, d));
  for (int j = 0; j < dim; ++j) mean.temperature.e[j] += missing * n.e[j];
}

/// Add the derivatives by the conservative variables of a and b of the part of the flux that follows the jump along the
/// edge, the viscosity and the velocity in the work held fixed.
/// distance  d . n
template <int dim, class T>
LEONHARD_INLINE void add_viscous_jacobians(const ViscousConstants& k, const Primitive<dim, T>& a,
                                           const Primitive<dim, T>& b, const Vector<dim, T>& n, const T& distance,
                                           Block<dim, T>& by_a, Block<dim, T>& by_b) {
  const Primitive<dim, T> at = mean_state(a, b);
  const T scale = viscosity<T>(k, temperature(k.gamma, at)) / distance;
  const auto add = [&](const Primitive<dim, T>& w, const T& factor, Block<dim, T>& block) __attribute__((always_inline)) {
    const T inverse_rho = 1.0 / w.rho;
    const T heat = (k.inverse_prandtl / (k.gamma - 1)) * k.gamma * inverse_rho;
    const Components<dim, T> by_p = pressure_gradient(k.gamma, w.velocity);
    Components<dim, T> energy;
    for (int j = 0; j < dim + 2; ++j) energy.e[j] = heat * by_p.e[j];
    energy.e[0] -= heat * w.p * inverse_rho;
    for (int i = 0; i < dim; ++i) {
      // stress_i = (delta_ij + n_i n_j / 3) dV_j, where dV_j = (dq_j - V_j dq_0) / rho
      T along = constant<T>(0);
      for (int j = 0; j < dim; ++j) {
        const T weight = inverse_rho * ((i == j ? 1.0 : 0.0) + (1.0 / 3.0) * n.e[i] * n.e[j]);
        along += weight * w.velocity.e[j];
        block.m[1 + i][1 + j] += factor * weight;
        energy.e[1 + j] += at.velocity.e[i] * weight;
      }
      block.m[1 + i][0] -= factor * along;
      energy.e[0] -= at.velocity.e[i] * along;
    }
    for (int j = 0; j < dim + 2; ++j) block.m[dim + 1][j] += factor * energy.e[j];
  };
  add(a, scale, by_a);
  add(b, T(-scale), by_b);
}

}  // namespace leonhard::solver
