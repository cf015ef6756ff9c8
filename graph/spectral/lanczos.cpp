// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "leonhard/graph/spectral/eigensolvers.hpp"
#include "leonhard/graph/spectral/linear_algebra.hpp"

namespace leonhard::graph::detail {
namespace {

/// A symmetric tridiagonal matrix: off[i] couples i and i + 1.
struct Tridiagonal {
  std::vector<double> diagonal, off;
};

/// Whether T - shift has a negative pivot, that is, T an eigenvalue below the shift (Sylvester).
bool has_eigenvalue_below(const Tridiagonal& t, double shift) {
  double pivot = 1;
  for (std::size_t i = 0; i < t.diagonal.size(); ++i) {
    const double coupling = i == 0 ? 0 : t.off[i - 1] * t.off[i - 1] / pivot;
    pivot = t.diagonal[i] - shift - coupling;
    if (pivot < 0) return true;
    if (pivot == 0) pivot = std::numeric_limits<double>::min();
  }
  return false;
}

/// A lower bound of the smallest eigenvalue, tight to rounding, by bisection.
double smallest_eigenvalue(const Tridiagonal& t) {
  double low = 0;  // Laplacians have no negative eigenvalue, nor have their projections
  double high = *std::ranges::min_element(t.diagonal);
  while (true) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return low;
    (has_eigenvalue_below(t, middle) ? high : low) = middle;
  }
}

/// The eigenvector to the smallest eigenvalue by inverse iteration; the shift lies below all eigenvalues, so
/// that elimination needs no pivoting.
std::vector<double> smallest_eigenvector(const Tridiagonal& t, double shift) {
  const std::size_t m = t.diagonal.size();
  const double least_pivot = 1e-16 * *std::ranges::max_element(t.diagonal);
  std::vector<double> pivot(m), s(m, 1.0);
  for (std::size_t i = 0; i < m; ++i) {
    const double coupling = i == 0 ? 0 : t.off[i - 1] * t.off[i - 1] / pivot[i - 1];
    pivot[i] = std::max(t.diagonal[i] - shift - coupling, least_pivot);
  }
  constexpr int steps = 4;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 1; i < m; ++i) s[i] -= t.off[i - 1] / pivot[i - 1] * s[i - 1];
    for (std::size_t i = m; i-- > 0;) {
      const double above = i + 1 == m ? 0 : t.off[i] * s[i + 1];
      s[i] = (s[i] - above) / pivot[i];
    }
    scale(s, 1 / norm(s));
  }
  return s;
}

}  // namespace

EigenIterate lanczos(const CsrGraph& graph, const FiedlerOptions& options) {
  constexpr std::size_t check_every = 10;
  const std::size_t n = vertex_count(graph);
  const std::size_t most = std::min<std::size_t>(options.max_iterations, n - 1);
  const SparseMatrix matrix = laplacian(graph);
  const double floor = residual_floor(graph);
  std::mt19937_64 random(options.seed);
  std::vector<double> next = random_vector(n, random), image(n);
  static_cast<void>(orthonormalise(next, {}));
  std::vector<std::vector<double>> basis;
  Tridiagonal t;
  while (true) {
    basis.push_back(next);
    multiply(matrix, basis.back(), image);
    t.diagonal.push_back(dot(basis.back(), image));
    next = image;
    const bool goes_on = orthonormalise(next, basis);
    const double beta = goes_on ? dot(next, image) : 0;  // beta 0: the subspace is invariant, the pair exact
    const std::size_t m = basis.size();
    const bool stopping = options.stop.stop_requested();
    if (m % check_every == 0 || m >= most || beta == 0 || stopping) {
      const double value = smallest_eigenvalue(t);
      const std::vector<double> s = smallest_eigenvector(t, value);
      const bool converged =
          std::abs(beta * s.back()) <= std::max(options.tolerance * value, floor) || m == n - 1;
      if (converged || m >= most || stopping) {
        std::vector<double> x(n, 0.0);
        for (std::size_t i = 0; i < m; ++i) add_scaled(x, s[i], basis[i]);
        const FiedlerOutcome outcome = converged  ? FiedlerOutcome::converged
                                       : stopping ? FiedlerOutcome::stopped
                                                  : FiedlerOutcome::iteration_limit;
        return {outcome, std::move(x), static_cast<std::uint32_t>(m)};
      }
    }
    t.off.push_back(beta);
  }
}

}  // namespace leonhard::graph::detail
