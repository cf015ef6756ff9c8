// SPDX-License-Identifier: MIT
#include "leonhard/graph/fiedler.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "leonhard/graph/spectral/eigensolvers.hpp"
#include "leonhard/graph/spectral/linear_algebra.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::graph {
namespace {

using namespace detail;

constexpr std::uint32_t dense_limit = 32;  ///< up to here a dense eigensolution is cheapest

/// Exact answer for a graph of several components: +, constant, on the first; -, constant, elsewhere.
std::vector<double> component_vector(const Components& parts) {
  const auto first = static_cast<double>(parts.sizes.front());
  const double others = static_cast<double>(parts.component_of.size()) - first;
  std::vector<double> x;
  x.reserve(parts.component_of.size());
  for (const std::uint32_t component : parts.component_of)
    x.push_back(component == 0 ? std::sqrt(others / first) : -std::sqrt(first / others));
  scale(x, 1 / norm(x));
  return x;
}

EigenIterate dense_solution(const CsrGraph& graph) {
  const std::size_t n = vertex_count(graph);
  const SparseMatrix sparse = laplacian(graph);
  // The constant vector's eigenvalue is lifted from 0 above all others (Gershgorin), so that lambda_2 comes
  // first.
  double lift = 0;
  for (std::uint32_t v = 0; v < n; ++v) lift = std::max(lift, 3.0 * degree(graph, v));
  std::vector<double> a(n * n, lift / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = sparse.start[i]; k < sparse.start[i + 1]; ++k)
      a[i * n + sparse.column[k]] += sparse.value[k];
  const DenseEigen eigen = symmetric_eigen(std::move(a), n);
  const auto smallest = eigen.vector(0);
  return {FiedlerOutcome::converged, {smallest.begin(), smallest.end()}, 0};
}

/// Norm 1, mean 0, and a sign that does not depend on the solver.
void normalise(std::vector<double>& x) {
  remove_mean(x);
  double largest = 0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  const auto decisive = std::ranges::find_if(x, [&](double value) { return std::abs(value) >= largest / 2; });
  scale(x, (*decisive < 0 ? -1 : 1) / norm(x));
}

EigenIterate iterate(const CsrGraph& graph, const FiedlerOptions& options) {
  if (options.method == FiedlerMethod::lanczos) return lanczos(graph, options);
  return vertex_count(graph) <= dense_limit ? dense_solution(graph) : davidson(graph, options);
}

}  // namespace

double detail::residual_floor(const CsrGraph& graph) {
  std::uint32_t largest = 0;
  for (std::uint32_t v = 0; v < vertex_count(graph); ++v) largest = std::max(largest, degree(graph, v));
  return 1e-14 * largest;
}

Fiedler fiedler(const CsrGraph& graph, const FiedlerOptions& options) {
  if (vertex_count(graph) < 2)
    throw InputError("graph",
                     "a graph of " + std::to_string(vertex_count(graph)) + " vertices has no Fiedler vector",
                     "give at least two vertices");
  if (!(options.tolerance > 0) || options.max_iterations == 0)
    throw InputError("options",
                     "tolerance " + std::to_string(options.tolerance) + ", at most " +
                         std::to_string(options.max_iterations) + " iterations",
                     "both must be positive");
  Fiedler result;
  if (const Components parts = components(graph); parts.count() > 1) {
    result.outcome = FiedlerOutcome::converged;
    result.vector = component_vector(parts);
    return result;
  }
  EigenIterate found = iterate(graph, options);
  normalise(found.vector);
  std::vector<double> residual = laplacian_product(graph, found.vector);
  result.value = dot(found.vector, residual);
  add_scaled(residual, -result.value, found.vector);
  result.outcome = found.outcome;
  result.residual = norm(residual);
  result.iterations = found.iterations;
  result.vector = std::move(found.vector);
  return result;
}

std::vector<double> laplacian_product(const CsrGraph& graph, const std::vector<double>& x) {
  const std::uint32_t n = vertex_count(graph);
  if (x.size() != n)
    throw InputError("x", std::to_string(x.size()) + " entries for " + std::to_string(n) + " vertices",
                     "give one a vertex");
  std::vector<double> y(n);
  for (std::uint32_t v = 0; v < n; ++v) {
    double sum = degree(graph, v) * x[v];
    for (const std::uint32_t w : neighbours(graph, v)) sum -= x[w];
    y[v] = sum;
  }
  return y;
}

}  // namespace leonhard::graph
