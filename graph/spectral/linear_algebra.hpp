// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <stop_token>
#include <vector>

#include "leonhard/graph/mesh_graph.hpp"

/// The little linear algebra that the eigensolvers of this room need; not for callers outside it.
namespace leonhard::graph::detail {

/// A sparse matrix in compressed rows.
struct SparseMatrix {
  std::uint32_t columns{};
  std::vector<std::size_t> start{0};  ///< rows + 1 entries
  std::vector<std::uint32_t> column;
  std::vector<double> value;

  [[nodiscard]] std::uint32_t rows() const { return static_cast<std::uint32_t>(start.size() - 1); }
};

/// D - A, the diagonal first in each row.
[[nodiscard]] SparseMatrix laplacian(const CsrGraph& graph);
[[nodiscard]] SparseMatrix transpose(const SparseMatrix& a);
/// stop  asked every few thousand rows; those after a request are left out
[[nodiscard]] SparseMatrix multiply(const SparseMatrix& a, const SparseMatrix& b,
                                    const std::stop_token& stop = {});
/// y = A x
void multiply(const SparseMatrix& a, std::span<const double> x, std::span<double> y);

/// Collects one sparse row at a time: add() in any sequence, then flush() appends the row to a matrix.
class RowAccumulator {
 public:
  explicit RowAccumulator(std::uint32_t columns) : sum_(columns, 0.0), present_(columns, 0) {}
  void add(std::uint32_t column, double value) {
    if (!present_[column]) {
      present_[column] = 1;
      touched_.push_back(column);
    }
    sum_[column] += value;
  }
  void flush(SparseMatrix& matrix);

 private:
  std::vector<double> sum_;
  std::vector<char> present_;
  std::vector<std::uint32_t> touched_;
};

[[nodiscard]] double dot(std::span<const double> x, std::span<const double> y);
[[nodiscard]] double norm(std::span<const double> x);
void add_scaled(std::span<double> y, double factor, std::span<const double> x);  ///< y += factor x
void scale(std::span<double> x, double factor);
void remove_mean(std::span<double> x);

/// Uniform in [-1, 1), the same numbers on every platform (the standard's distributions promise no such
/// thing).
[[nodiscard]] std::vector<double> random_vector(std::size_t size, std::mt19937_64& random);

/// Makes x orthogonal to the constant vector and to an orthonormal basis, and of norm 1. Two passes, which
/// is enough (Kahan; Parlett, The Symmetric Eigenvalue Problem, 6.9).
/// returns false, x undefined, if nothing but rounding was left of x
[[nodiscard]] bool orthonormalise(std::span<double> x, std::span<const std::vector<double>> basis);

/// All eigenpairs of a small dense symmetric matrix, ascending.
struct DenseEigen {
  std::vector<double> values;
  std::vector<double> vectors;  ///< column-major: vector j is entries [j*n, (j+1)*n)

  [[nodiscard]] std::span<const double> vector(std::size_t j) const {
    return std::span(vectors).subspan(j * values.size(), values.size());
  }
};

/// Method: cyclic Jacobi (Golub and Van Loan, 8.5). Cost some 10 n^3.
[[nodiscard]] DenseEigen symmetric_eigen(std::vector<double> a, std::size_t n);

/// Dense Cholesky factor for repeated solves.
class DenseCholesky {
 public:
  DenseCholesky() = default;
  /// a  symmetric positive definite, n by n, row-major
  DenseCholesky(std::vector<double> a, std::size_t n);
  void solve(std::span<double> x) const;  ///< x := A^-1 x

 private:
  std::size_t n_ = 0;
  std::vector<double> l_;
};

}  // namespace leonhard::graph::detail
