// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/solver/flux/roe.hpp"
#include "leonhard/solver/flux/rusanov.hpp"
#include "leonhard/solver/kinds.hpp"

// Jacobians by conservative variables, for the implicit operator.

namespace leonhard::solver {

/// A square matrix by conservative variables; m[row][column].
template <int dim, class T>
struct Block {
  T m[dim + 2][dim + 2];
};

/// speed I + (1, V, H) x across + (0, n, Vn) x along, scaled: the shape of A and of Roe's |A|.
template <int dim, class T>
struct RankTwo {
  Vector<dim, T> velocity;
  T enthalpy;
  Vector<dim, T> n;
  T normal_speed, speed;
  Components<dim, T> across, along;

  template <class Scale>
  [[gnu::always_inline]] inline void add_to(Block<dim, T>& block, const Scale& scale) const {
    Components<dim, T> left, right;
    left.e[0] = constant<T>(1), right.e[0] = constant<T>(0);
    for (int i = 0; i < dim; ++i) left.e[1 + i] = velocity.e[i], right.e[1 + i] = n.e[i];
    left.e[dim + 1] = enthalpy, right.e[dim + 1] = normal_speed;
    for (int i = 0; i < dim + 2; ++i) {
      for (int j = 0; j < dim + 2; ++j)
        block.m[i][j] += scale * (left.e[i] * across.e[j] + right.e[i] * along.e[j]);
      block.m[i][i] += scale * speed;
    }
  }
};

/// Derivative of pressure by the conservative variables at a velocity.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> pressure_gradient(double gamma, const Vector<dim, T>& velocity) {
  const double g = gamma - 1;
  Components<dim, T> by;
  by.e[0] = 0.5 * g * dot(velocity, velocity);
  for (int i = 0; i < dim; ++i) by.e[1 + i] = -g * velocity.e[i];
  by.e[dim + 1] = constant<T>(g);
  return by;
}

/// Density times the derivative of the normal velocity by the conservative variables.
template <int dim, class T>
LEONHARD_INLINE Components<dim, T> normal_velocity_gradient(const T& normal_speed, const Vector<dim, T>& n) {
  Components<dim, T> by;
  by.e[0] = -normal_speed;
  for (int i = 0; i < dim; ++i) by.e[1 + i] = n.e[i];
  by.e[dim + 1] = constant<T>(0);
  return by;
}

/// The exact Jacobian of euler_flux.
template <int dim, class T>
LEONHARD_INLINE RankTwo<dim, T> euler_jacobian(double gamma, const Primitive<dim, T>& w,
                                               const Vector<dim, T>& n) {
  const T vn = dot(w.velocity, n);
  return {w.velocity,
          total_enthalpy(gamma, w),
          n,
          vn,
          vn,
          normal_velocity_gradient(vn, n),
          pressure_gradient(gamma, w.velocity)};
}

/// Roe's |A| of these waves.
template <int dim, class T>
LEONHARD_INLINE RankTwo<dim, T> roe_matrix(const FluxConstants& k, const RoeWaves<dim, T>& w,
                                           const Vector<dim, T>& n) {
  const Components<dim, T> by_p = pressure_gradient(k.gamma, w.velocity);
  Components<dim, T> by_n = normal_velocity_gradient(w.normal_speed, n);
  for (T& component : by_n.e) component *= w.share;
  RankTwo<dim, T> d{w.velocity, w.enthalpy, n, w.normal_speed, w.slow, {}, {}};
  for (int j = 0; j < dim + 2; ++j) {
    d.across.e[j] = (w.mean_fast * by_p.e[j] * w.inverse_c + w.diff_fast * by_n.e[j]) * w.inverse_c;
    d.along.e[j] = w.mean_fast * by_n.e[j] + w.diff_fast * by_p.e[j] * w.inverse_c;
  }
  return d;
}

/// (A(a) + D) / 2 and (A(b) - D) / 2, the Jacobians by a and by b of a flux with dissipation D held fixed.
template <int dim, class T>
LEONHARD_INLINE void upwind_jacobians(double gamma, const Primitive<dim, T>& a, const Primitive<dim, T>& b,
                                      const Vector<dim, T>& n, const RankTwo<dim, T>& dissipation,
                                      Block<dim, T>& by_a, Block<dim, T>& by_b) {
  for (int i = 0; i < dim + 2; ++i)
    for (int j = 0; j < dim + 2; ++j) by_a.m[i][j] = by_b.m[i][j] = constant<T>(0);
  euler_jacobian(gamma, a, n).add_to(by_a, 0.5);
  euler_jacobian(gamma, b, n).add_to(by_b, 0.5);
  dissipation.add_to(by_a, 0.5);
  dissipation.add_to(by_b, -0.5);
}

/// Jacobians of flux_roe by the conservative variables of a and of b, with Roe's matrix held fixed
/// (T. J. Barth, AIAA 87-0595).
template <int dim, class T>
LEONHARD_INLINE void flux_roe_jacobians(const FluxConstants& k, const Primitive<dim, T>& a,
                                        const Primitive<dim, T>& b, const Vector<dim, T>& n,
                                        Block<dim, T>& by_a, Block<dim, T>& by_b) {
  upwind_jacobians(k.gamma, a, b, n, roe_matrix(k, roe_waves(k, a, b, n, constant<T>(1)), n), by_a, by_b);
}

/// Between those of flux_roe and of flux_roe_low_mach: the root of the latter's share. With the share itself incomplete
/// factors of the matrix do not hold at small Mach numbers, with Roe's it is too far from the flux.
template <int dim, class T>
LEONHARD_INLINE void flux_roe_low_mach_jacobians(const FluxConstants& k, const Primitive<dim, T>& a,
                                                 const Primitive<dim, T>& b, const Vector<dim, T>& n,
                                                 Block<dim, T>& by_a, Block<dim, T>& by_b) {
  const T share = root(low_mach_share(k, a, b));
  upwind_jacobians(k.gamma, a, b, n, roe_matrix(k, roe_waves(k, a, b, n, share), n), by_a, by_b);
}

/// Jacobians of flux_rusanov, its speed held fixed.
template <int dim, class T>
LEONHARD_INLINE void flux_rusanov_jacobians(const FluxConstants& k, const Primitive<dim, T>& a,
                                            const Primitive<dim, T>& b, const Vector<dim, T>& n,
                                            Block<dim, T>& by_a, Block<dim, T>& by_b) {
  RankTwo<dim, T> speed{a.velocity, constant<T>(0), n, constant<T>(0), fastest_wave(k.gamma, a, b, n), {},
                        {}};
  for (int j = 0; j < dim + 2; ++j) speed.across.e[j] = speed.along.e[j] = constant<T>(0);
  upwind_jacobians(k.gamma, a, b, n, speed, by_a, by_b);
}

/// The Jacobians that the implicit operator takes for a flux: of Roe's flux, its low-Mach version or Rusanov's, whichever
/// dissipates alike.
template <FluxKind kind, int dim, class T>
LEONHARD_INLINE void flux_jacobians(const FluxConstants& k, const Primitive<dim, T>& a,
                                    const Primitive<dim, T>& b, const Vector<dim, T>& n, Block<dim, T>& by_a,
                                    Block<dim, T>& by_b) {
  if constexpr (kind == FluxKind::roe_low_mach)
    flux_roe_low_mach_jacobians(k, a, b, n, by_a, by_b);
  else if constexpr (kind == FluxKind::rusanov)
    flux_rusanov_jacobians(k, a, b, n, by_a, by_b);
  else
    flux_roe_jacobians(k, a, b, n, by_a, by_b);
}

/// Call work.operator()<kind>() with the kind whose Jacobians those of `kind` are.
template <class Work>
LEONHARD_INLINE void with_jacobian(FluxKind kind, const Work& work) {
  switch (kind) {
    case FluxKind::roe_low_mach:
    case FluxKind::hllc_low_mach:
    case FluxKind::ausm_plus_up:
      return work.template operator()<FluxKind::roe_low_mach>();
    case FluxKind::rusanov:
    case FluxKind::kep_scalar:
      return work.template operator()<FluxKind::rusanov>();
    case FluxKind::roe:
    case FluxKind::hllc:
    case FluxKind::van_leer:
    case FluxKind::kep_matrix:
      return work.template operator()<FluxKind::roe>();
  }
}

}  // namespace leonhard::solver
