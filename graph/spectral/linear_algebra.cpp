// SPDX-License-Identifier: MIT
#include "leonhard/graph/spectral/linear_algebra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace leonhard::graph::detail {

SparseMatrix laplacian(const CsrGraph& graph) {
  SparseMatrix a;
  const std::uint32_t n = vertex_count(graph);
  a.columns = n;
  a.start.reserve(n + std::size_t{1});
  a.column.reserve(n + 2 * edge_count(graph));
  a.value.reserve(a.column.capacity());
  for (std::uint32_t v = 0; v < n; ++v) {
    a.column.push_back(v);
    a.value.push_back(degree(graph, v));
    for (const std::uint32_t w : neighbours(graph, v)) {
      a.column.push_back(w);
      a.value.push_back(-1);
    }
    a.start.push_back(a.column.size());
  }
  return a;
}

SparseMatrix transpose(const SparseMatrix& a) {
  SparseMatrix t;
  t.columns = a.rows();
  t.start.assign(a.columns + std::size_t{1}, 0);
  for (const std::uint32_t c : a.column) ++t.start[c + std::size_t{1}];
  std::partial_sum(t.start.begin(), t.start.end(), t.start.begin());
  t.column.resize(a.column.size());
  t.value.resize(a.value.size());
  std::vector<std::size_t> next(t.start.begin(), t.start.end() - 1);
  for (std::uint32_t row = 0; row < a.rows(); ++row)
    for (std::size_t k = a.start[row]; k < a.start[row + std::size_t{1}]; ++k) {
      const std::size_t to = next[a.column[k]]++;
      t.column[to] = row;
      t.value[to] = a.value[k];
    }
  return t;
}

SparseMatrix multiply(const SparseMatrix& a, const SparseMatrix& b, const std::stop_token& stop) {
  constexpr std::uint32_t between_looks = 4096;
  SparseMatrix c;
  c.columns = b.columns;
  RowAccumulator row_sum(b.columns);
  for (std::uint32_t row = 0; row < a.rows(); ++row) {
    if (row % between_looks == 0 && stop.stop_requested()) break;
    for (std::size_t k = a.start[row]; k < a.start[row + std::size_t{1}]; ++k) {
      const std::size_t link = a.column[k];
      for (std::size_t l = b.start[link]; l < b.start[link + 1]; ++l)
        row_sum.add(b.column[l], a.value[k] * b.value[l]);
    }
    row_sum.flush(c);
  }
  return c;
}

void multiply(const SparseMatrix& a, std::span<const double> x, std::span<double> y) {
  for (std::size_t row = 0; row + 1 < a.start.size(); ++row) {
    double sum = 0;
    for (std::size_t k = a.start[row]; k < a.start[row + 1]; ++k) sum += a.value[k] * x[a.column[k]];
    y[row] = sum;
  }
}

void RowAccumulator::flush(SparseMatrix& matrix) {
  for (const std::uint32_t c : touched_) {
    matrix.column.push_back(c);
    matrix.value.push_back(sum_[c]);
    sum_[c] = 0;
    present_[c] = 0;
  }
  touched_.clear();
  matrix.start.push_back(matrix.column.size());
}

double dot(std::span<const double> x, std::span<const double> y) {
  double sum[4] = {0, 0, 0, 0};  // four running sums: the additions need not wait for one another
  std::size_t i = 0;
  for (; i + 4 <= x.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k) sum[k] += x[i + k] * y[i + k];
  for (; i < x.size(); ++i) sum[0] += x[i] * y[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

double norm(std::span<const double> x) { return std::sqrt(dot(x, x)); }

void add_scaled(std::span<double> y, double factor, std::span<const double> x) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += factor * x[i];
}

void scale(std::span<double> x, double factor) {
  for (double& value : x) value *= factor;
}

void remove_mean(std::span<double> x) {
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  for (double& value : x) value -= mean;
}

std::vector<double> random_vector(std::size_t size, std::mt19937_64& random) {
  std::vector<double> x(size);
  for (double& value : x) value = static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
  return x;
}

bool orthonormalise(std::span<double> x, std::span<const std::vector<double>> basis) {
  const double before = norm(x);
  for (int pass = 0; pass < 2; ++pass) {
    remove_mean(x);
    for (const std::vector<double>& v : basis) add_scaled(x, -dot(x, v), v);
  }
  const double after = norm(x);
  if (!(after > 1e-13 * before)) return false;
  scale(x, 1 / after);
  return true;
}

namespace {

/// One Jacobi rotation in the plane (p, q) that makes a[p][q] zero.
void rotate(std::vector<double>& a, std::vector<double>& vectors, std::size_t n, std::size_t p,
            std::size_t q) {
  const double apq = a[p * n + q];
  if (apq == 0) return;
  const double tau = (a[q * n + q] - a[p * n + p]) / (2 * apq);
  const double t = (tau >= 0 ? 1.0 : -1.0) / (std::abs(tau) + std::hypot(1.0, tau));
  const double c = 1 / std::hypot(1.0, t), s = t * c;
  for (std::size_t k = 0; k < n; ++k) {
    const double akp = a[k * n + p], akq = a[k * n + q];
    a[k * n + p] = c * akp - s * akq;
    a[k * n + q] = s * akp + c * akq;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const double apk = a[p * n + k], aqk = a[q * n + k];
    a[p * n + k] = c * apk - s * aqk;
    a[q * n + k] = s * apk + c * aqk;
    const double vp = vectors[p * n + k], vq = vectors[q * n + k];
    vectors[p * n + k] = c * vp - s * vq;
    vectors[q * n + k] = s * vp + c * vq;
  }
}

}  // namespace

DenseEigen symmetric_eigen(std::vector<double> a, std::size_t n) {
  std::vector<double> vectors(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) vectors[i * n + i] = 1;
  constexpr int max_sweeps = 60;  // Jacobi converges quadratically: some 8 sweeps at these sizes
  const double total = norm(a);
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    double off_diagonal = 0;
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) off_diagonal = std::max(off_diagonal, std::abs(a[p * n + q]));
    if (off_diagonal <= std::numeric_limits<double>::epsilon() * 0.01 * total) break;
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) rotate(a, vectors, n, p, q);
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return a[i * n + i]; });
  DenseEigen result;
  for (const std::size_t i : order) {
    result.values.push_back(a[i * n + i]);
    result.vectors.insert(result.vectors.end(), vectors.begin() + static_cast<std::ptrdiff_t>(i * n),
                          vectors.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
  }
  return result;
}

DenseCholesky::DenseCholesky(std::vector<double> a, std::size_t n) : n_(n), l_(std::move(a)) {
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const auto row_i = std::span(l_).subspan(i * n, j), row_j = std::span(l_).subspan(j * n, j);
      const double entry = l_[i * n + j];
      const double rest = entry - dot(row_i, row_j);
      // A pivot lost to rounding would end in NaN; one at the level of rounding keeps the factor usable.
      const double pivot = std::max(rest, std::numeric_limits<double>::epsilon() * entry);
      l_[i * n + j] = i == j ? std::sqrt(pivot) : rest / l_[j * n + j];
    }
}

void DenseCholesky::solve(std::span<double> x) const {
  for (std::size_t i = 0; i < n_; ++i) {
    const double known = dot(std::span(l_).subspan(i * n_, i), x.first(i));
    x[i] = (x[i] - known) / l_[i * n_ + i];
  }
  for (std::size_t i = n_; i-- > 0;) {
    x[i] /= l_[i * n_ + i];
    add_scaled(x.first(i), -x[i], std::span(l_).subspan(i * n_, i));
  }
}

}  // namespace leonhard::graph::detail
