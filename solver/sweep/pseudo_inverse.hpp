// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "leonhard/solver/gas.hpp"

namespace leonhard::solver {

/// A symmetric matrix of an order of the space's dimension, row by row.
template <int dim>
using SymmetricMatrix = std::array<Axes<dim>, dim>;

template <int dim>
[[nodiscard]] double trace(const SymmetricMatrix<dim>& m) {
  double sum = 0;
  for (std::size_t i = 0; i < dim; ++i) sum += m[i][i];
  return sum;
}

[[nodiscard]] inline SymmetricMatrix<2> adjugate(const SymmetricMatrix<2>& m) {
  return {{{m[1][1], -m[0][1]}, {-m[0][1], m[0][0]}}};
}
[[nodiscard]] inline SymmetricMatrix<3> adjugate(const SymmetricMatrix<3>& m) {
  SymmetricMatrix<3> result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Axes<3>&row = m[(i + 1) % 3], &next = m[(i + 2) % 3];
      result[i][j] = row[(j + 1) % 3] * next[(j + 2) % 3] - row[(j + 2) % 3] * next[(j + 1) % 3];
    }
  return result;
}

template <int dim>
[[nodiscard]] SymmetricMatrix<dim> scaled(double factor, SymmetricMatrix<dim> m) {
  for (Axes<dim>& row : m)
    for (double& entry : row) entry *= factor;
  return m;
}

template <int dim>
[[nodiscard]] SymmetricMatrix<dim> sum(SymmetricMatrix<dim> a, const SymmetricMatrix<dim>& b) {
  for (std::size_t i = 0; i < dim; ++i)
    for (std::size_t j = 0; j < dim; ++j) a[i][j] += b[i][j];
  return a;
}

/// The inverse of a symmetric matrix without negative eigenvalues; where it is singular, the inverse on its range
/// (Moore and Penrose). It counts as singular where its determinant is that of rounding errors, 1e-12 of what the trace allows.
template <int dim>
[[nodiscard]] SymmetricMatrix<dim> pseudo_inverse(const SymmetricMatrix<dim>& m) {
  const double t = trace<dim>(m);
  if (!(t > 0)) return {};
  const SymmetricMatrix<dim> adjoint = adjugate(m);
  double determinant = 0;
  for (std::size_t j = 0; j < dim; ++j) determinant += m[0][j] * adjoint[0][j];
  if (determinant > 1e-12 * (dim == 2 ? t * t : t * t * t)) return scaled<dim>(1 / determinant, adjoint);
  if constexpr (dim == 3) {
    const double products = trace<dim>(adjoint);  // of the eigenvalues, two by two: one that is not small where the rank is two
    if (products > 1e-12 * t * t) {
      const SymmetricMatrix<dim> normal = scaled<dim>(1 / products, adjoint);  // projects on what is not in the range
      return sum<dim>(pseudo_inverse<dim>(sum<dim>(m, scaled<dim>(t, normal))), scaled<dim>(-1 / t, normal));
    }
  }
  return scaled<dim>(1 / (t * t), m);
}

}  // namespace leonhard::solver
