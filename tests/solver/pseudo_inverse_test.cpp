// SPDX-License-Identifier: MIT
#include "leonhard/solver/sweep/pseudo_inverse.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using namespace leonhard;
using namespace leonhard::solver;

namespace {

template <int dim>
SymmetricMatrix<dim> product(const SymmetricMatrix<dim>& a, const SymmetricMatrix<dim>& b) {
  SymmetricMatrix<dim> result{};
  for (std::size_t i = 0; i < dim; ++i)
    for (std::size_t j = 0; j < dim; ++j)
      for (std::size_t k = 0; k < dim; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}

template <int dim>
void check_equal(const SymmetricMatrix<dim>& a, const SymmetricMatrix<dim>& b, double tolerance) {
  for (std::size_t i = 0; i < dim; ++i)
    for (std::size_t j = 0; j < dim; ++j) CHECK(std::abs(a[i][j] - b[i][j]) <= tolerance);
}

/// Sums of the dyads of random unit vectors within a space of a lower dimension that lies at random.
template <int dim>
void check_penrose(int rank) {
  std::mt19937_64 random(static_cast<unsigned>(10 * dim + rank));
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Axes<dim>> range(static_cast<std::size_t>(rank));
    for (Axes<dim>& axis : range)
      for (double& x : axis) x = normal(random);
    SymmetricMatrix<dim> m{};
    for (int vectors = 0; vectors < rank + 4; ++vectors) {
      Axes<dim> d{};
      for (const Axes<dim>& axis : range) {
        const double share = normal(random);
        for (std::size_t i = 0; i < dim; ++i) d[i] += share * axis[i];
      }
      const double square = dot(d, d);
      for (std::size_t i = 0; i < dim; ++i)
        for (std::size_t j = 0; j < dim; ++j) m[i][j] += square > 0 ? d[i] * d[j] / square : 0;
    }
    const SymmetricMatrix<dim> inverse = pseudo_inverse<dim>(m);
    double size = 0;
    for (const Axes<dim>& row : inverse) size = std::max(size, std::sqrt(dot(row, row)));
    if (size > 1e4) continue;  // the vectors nearly span less: what is right is lost to rounding
    check_equal<dim>(product<dim>(m, product<dim>(inverse, m)), m, 1e-11 * (1 + size));
    check_equal<dim>(product<dim>(inverse, product<dim>(m, inverse)), inverse, 1e-11 * (1 + size * size));
  }
}

}  // namespace

TEST_CASE("pseudo_inverses_satisfy_penrose_s_equations_at_any_rank") {
  for (int rank = 0; rank <= 2; ++rank) check_penrose<2>(rank);
  for (int rank = 0; rank <= 3; ++rank) check_penrose<3>(rank);
}
