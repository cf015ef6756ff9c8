// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>

#include "leonhard/graph/spectral/eigensolvers.hpp"
#include "leonhard/graph/spectral/linear_algebra.hpp"
#include "leonhard/graph/spectral/multilevel_cycle.hpp"

namespace leonhard::graph::detail {
namespace {

constexpr std::size_t start_vectors = 3;
constexpr std::size_t kept_at_restart = 4;
constexpr std::size_t largest_subspace = 16;

/// An orthonormal basis V, its image L V and the projection V^T L V.
class Subspace {
 public:
  explicit Subspace(const SparseMatrix& matrix) : matrix_(matrix) {}

  [[nodiscard]] std::size_t dimension() const { return basis_.size(); }

  /// returns false, nothing added, if x lies in the subspace
  bool add(std::vector<double> x) {
    if (!orthonormalise(x, basis_)) return false;
    std::vector<double> image(x.size());
    multiply(matrix_, x, image);
    basis_.push_back(std::move(x));
    image_.push_back(std::move(image));
    for (std::size_t i = 0; i < dimension(); ++i) projection_.push_back(dot(basis_[i], image_.back()));
    return true;
  }

  [[nodiscard]] DenseEigen ritz() const {
    const std::size_t k = dimension();
    std::vector<double> h(k * k);
    for (std::size_t j = 0, at = 0; j < k; ++j)
      for (std::size_t i = 0; i <= j; ++i, ++at) h[i * k + j] = h[j * k + i] = projection_[at];
    return symmetric_eigen(std::move(h), k);
  }

  /// The vector of the graph's space with these coefficients in the basis, and its image.
  [[nodiscard]] std::vector<double> vector(std::span<const double> y) const { return combine(basis_, y); }
  [[nodiscard]] std::vector<double> image(std::span<const double> y) const { return combine(image_, y); }

  /// Shrinks the subspace to its Ritz vectors of smallest value.
  void restart(const DenseEigen& ritz, std::size_t keep) {
    std::vector<std::vector<double>> basis, image;
    projection_.clear();
    for (std::size_t j = 0; j < keep; ++j) {
      basis.push_back(combine(basis_, ritz.vector(j)));
      image.push_back(combine(image_, ritz.vector(j)));
      projection_.insert(projection_.end(), j, 0.0);
      projection_.push_back(ritz.values[j]);
    }
    basis_ = std::move(basis);
    image_ = std::move(image);
  }

 private:
  static std::vector<double> combine(const std::vector<std::vector<double>>& vectors,
                                     std::span<const double> y) {
    std::vector<double> sum(vectors.front().size(), 0.0);
    for (std::size_t i = 0; i < y.size(); ++i) add_scaled(sum, y[i], vectors[i]);
    return sum;
  }

  const SparseMatrix& matrix_;
  std::vector<std::vector<double>> basis_, image_;
  std::vector<double> projection_;  ///< columns of the upper triangle one after another
};

}  // namespace

EigenIterate davidson(const CsrGraph& graph, const FiedlerOptions& options) {
  const std::size_t n = vertex_count(graph);
  MultilevelCycle cycle(graph, options.stop);
  Subspace subspace(cycle.matrix());
  std::mt19937_64 random(options.seed);
  std::vector<double> correction(n);
  std::uint32_t iterations = 0;
  const auto expand = [&](const std::vector<double>& residual) {
    cycle.apply(residual, correction);
    // A correction within the subspace (to rounding) adds nothing; any other direction does.
    if (!subspace.add(correction)) static_cast<void>(subspace.add(random_vector(n, random)));
    ++iterations;
  };
  for (std::size_t i = 0; i < start_vectors; ++i) {
    std::vector<double> start = random_vector(n, random);
    remove_mean(start);
    if (options.stop.stop_requested()) {  // no time for a cycle
      scale(start, 1 / norm(start));
      return {FiedlerOutcome::stopped, std::move(start), iterations};
    }
    expand(start);
  }
  const double floor = residual_floor(graph);
  while (true) {
    const DenseEigen ritz = subspace.ritz();
    std::vector<double> x = subspace.vector(ritz.vector(0));
    std::vector<double> residual = subspace.image(ritz.vector(0));
    add_scaled(residual, -ritz.values[0], x);
    if (norm(residual) <= std::max(options.tolerance * ritz.values[0], floor))
      return {FiedlerOutcome::converged, std::move(x), iterations};
    if (options.stop.stop_requested()) return {FiedlerOutcome::stopped, std::move(x), iterations};
    if (iterations >= options.max_iterations)
      return {FiedlerOutcome::iteration_limit, std::move(x), iterations};
    if (subspace.dimension() == largest_subspace) subspace.restart(ritz, kept_at_restart);
    expand(residual);
  }
}

}  // namespace leonhard::graph::detail
