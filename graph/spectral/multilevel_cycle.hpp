// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "leonhard/graph/spectral/linear_algebra.hpp"

namespace leonhard::graph::detail {

/// One multilevel V-cycle as an approximate inverse of the Laplacian of a connected graph, symmetric positive
/// definite on the complement of the constant vector; not for callers outside this room.
///
/// Levels: vertices are grouped with their neighbours into aggregates, the aggregates' indicator vectors are
/// smoothed by one damped Jacobi step into the columns of a prolongation P, and the next matrix is P^T A P,
/// until it is small enough for a dense factor. P maps the constant vector to the constant vector, so every
/// level's matrix has it as its kernel. Smoother: one Gauss-Seidel sweep forwards before, one backwards
/// after the coarse correction.
/// Method: Vanek, Mandel and Brezina, Computing 56 (1996) 179-196.
/// Cost O(m) to build and to apply for graphs of bounded degree.
class MultilevelCycle {
 public:
  /// stop  checked between the steps to each level; after a stop request the hierarchy is cut short, which is still a
  /// valid cycle
  explicit MultilevelCycle(const CsrGraph& graph, const std::stop_token& stop = {});

  /// z := approximate solution of L z = r
  ///
  /// r  sum zero. Uses scratch space: one thread at a time.
  void apply(std::span<const double> r, std::span<double> z) { cycle(0, r, z); }

  /// The Laplacian of the graph: the finest level's matrix.
  [[nodiscard]] const SparseMatrix& matrix() const { return levels_.front().matrix; }

 private:
  struct Level {
    SparseMatrix matrix;
    SparseMatrix prolongation;  ///< from the next level to this one; empty on the coarsest
    std::vector<double> diagonal, residual, coarse_right, coarse_solution;
  };

  void cycle(std::size_t depth, std::span<const double> r, std::span<double> z);
  void solve_coarsest(std::span<const double> r, std::span<double> z);

  std::vector<Level> levels_;
  DenseCholesky coarsest_;
  bool coarsest_is_dense_ = false;
};

}  // namespace leonhard::graph::detail
