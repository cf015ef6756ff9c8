// SPDX-License-Identifier: MIT
#include "leonhard/graph/spectral/multilevel_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace leonhard::graph::detail {
namespace {

constexpr std::uint32_t dense_limit = 200;
constexpr std::uint32_t unassigned = std::numeric_limits<std::uint32_t>::max();

std::vector<double> diagonal_of(const SparseMatrix& a) {
  std::vector<double> diagonal(a.rows(), 0.0);
  for (std::uint32_t i = 0; i < a.rows(); ++i)
    for (std::size_t k = a.start[i]; k < a.start[i + std::size_t{1}]; ++k)
      if (a.column[k] == i) diagonal[i] += a.value[k];
  return diagonal;
}

/// The couplings worth grouping along: those of at least a quarter of the row's largest.
SparseMatrix strong_part(const SparseMatrix& a) {
  SparseMatrix strong;
  strong.columns = a.columns;
  for (std::uint32_t i = 0; i < a.rows(); ++i) {
    double largest = 0;
    for (std::size_t k = a.start[i]; k < a.start[i + std::size_t{1}]; ++k)
      if (a.column[k] != i) largest = std::max(largest, -a.value[k]);
    for (std::size_t k = a.start[i]; k < a.start[i + std::size_t{1}]; ++k)
      if (a.column[k] != i && -a.value[k] >= 0.25 * largest) {
        strong.column.push_back(a.column[k]);
        strong.value.push_back(a.value[k]);
      }
    strong.start.push_back(strong.column.size());
  }
  return strong;
}

struct Aggregates {
  std::vector<std::uint32_t> of;  ///< one a row
  std::uint32_t count{};
};

/// Three passes: whole untouched neighbourhoods; the left-over next to an aggregate joins it; the rest
/// together with what is left around it.
Aggregates aggregate(const SparseMatrix& a) {
  const SparseMatrix strong = strong_part(a);
  const std::uint32_t n = a.rows();
  Aggregates groups{std::vector<std::uint32_t>(n, unassigned), 0};
  const auto row = [&](std::uint32_t i) {
    return std::span(strong.column)
        .subspan(strong.start[i], strong.start[i + std::size_t{1}] - strong.start[i]);
  };
  const auto is_free = [&](std::uint32_t j) { return groups.of[j] == unassigned; };
  for (std::uint32_t i = 0; i < n; ++i)
    if (is_free(i) && std::ranges::all_of(row(i), is_free)) {
      groups.of[i] = groups.count;
      for (const std::uint32_t j : row(i)) groups.of[j] = groups.count;
      ++groups.count;
    }
  const std::vector<std::uint32_t> seeds = groups.of;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < row(i).size() && is_free(i); ++k)
      if (seeds[row(i)[k]] != unassigned) groups.of[i] = seeds[row(i)[k]];
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!is_free(i)) continue;
    groups.of[i] = groups.count;
    for (const std::uint32_t j : row(i))
      if (is_free(j)) groups.of[j] = groups.count;
    ++groups.count;
  }
  return groups;
}

/// (I - omega D^-1 A) applied to the aggregates' indicator vectors.
SparseMatrix smoothed_prolongation(const SparseMatrix& a, std::span<const double> diagonal,
                                   const Aggregates& groups) {
  double spectral_bound = 0;  // of D^-1 A, by Gershgorin
  for (std::uint32_t i = 0; i < a.rows(); ++i) {
    double sum = 0;
    for (std::size_t k = a.start[i]; k < a.start[i + std::size_t{1}]; ++k) sum += std::abs(a.value[k]);
    spectral_bound = std::max(spectral_bound, sum / diagonal[i]);
  }
  const double omega = 4.0 / (3.0 * spectral_bound);
  SparseMatrix p;
  p.columns = groups.count;
  RowAccumulator row_sum(groups.count);
  for (std::uint32_t i = 0; i < a.rows(); ++i) {
    row_sum.add(groups.of[i], 1.0);
    for (std::size_t k = a.start[i]; k < a.start[i + std::size_t{1}]; ++k)
      row_sum.add(groups.of[a.column[k]], -omega * a.value[k] / diagonal[i]);
    row_sum.flush(p);
  }
  return p;
}

/// The singular matrix made definite by its mean diagonal times the projector on the constant vector.
DenseCholesky factor_with_kernel(const SparseMatrix& a, std::span<const double> diagonal) {
  const std::size_t n = a.rows();
  double trace = 0;
  for (const double d : diagonal) trace += d;
  std::vector<double> dense(n * n, trace / static_cast<double>(n * n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = a.start[i]; k < a.start[i + 1]; ++k) dense[i * n + a.column[k]] += a.value[k];
  return {std::move(dense), n};
}

/// z_i := (r_i - sum of a_ij z_j over j != i) / a_ii for one row.
void relax_row(const SparseMatrix& a, std::span<const double> diagonal, std::span<const double> r,
               std::span<double> z, std::size_t i) {
  double rest = r[i] + diagonal[i] * z[i];
  for (std::size_t k = a.start[i]; k < a.start[i + 1]; ++k) rest -= a.value[k] * z[a.column[k]];
  z[i] = rest / diagonal[i];
}

void sweep_forwards(const SparseMatrix& a, std::span<const double> diagonal, std::span<const double> r,
                    std::span<double> z) {
  for (std::size_t i = 0; i < z.size(); ++i) relax_row(a, diagonal, r, z, i);
}

void sweep_backwards(const SparseMatrix& a, std::span<const double> diagonal, std::span<const double> r,
                     std::span<double> z) {
  for (std::size_t i = z.size(); i-- > 0;) relax_row(a, diagonal, r, z, i);
}

}  // namespace

MultilevelCycle::MultilevelCycle(const CsrGraph& graph, const std::stop_token& stop) {
  levels_.push_back({laplacian(graph), {}, {}, {}, {}, {}});
  while (true) {
    Level& fine = levels_.back();
    const std::uint32_t n = fine.matrix.rows();
    fine.diagonal = diagonal_of(fine.matrix);
    fine.residual.resize(n);
    if (n <= dense_limit || stop.stop_requested()) break;
    const Aggregates groups = aggregate(fine.matrix);
    if (groups.count < 2 || groups.count > 0.8 * n)
      break;  // no longer worth a level: relaxation alone has to do
    if (stop.stop_requested()) break;
    SparseMatrix prolongation = smoothed_prolongation(fine.matrix, fine.diagonal, groups);
    const SparseMatrix product = multiply(fine.matrix, prolongation, stop);
    if (stop.stop_requested()) break;
    SparseMatrix coarse = multiply(transpose(prolongation), product, stop);
    if (stop.stop_requested()) break;
    fine.prolongation = std::move(prolongation);
    fine.coarse_right.resize(groups.count);
    fine.coarse_solution.resize(groups.count);
    levels_.push_back({std::move(coarse), {}, {}, {}, {}, {}});
  }
  const Level& last = levels_.back();
  coarsest_is_dense_ = last.matrix.rows() <= dense_limit;
  if (coarsest_is_dense_) coarsest_ = factor_with_kernel(last.matrix, last.diagonal);
}

void MultilevelCycle::solve_coarsest(std::span<const double> r, std::span<double> z) {
  const Level& level = levels_.back();
  if (coarsest_is_dense_) {
    std::ranges::copy(r, z.begin());
    coarsest_.solve(z);
    return;
  }
  constexpr int sweeps = 8;
  std::ranges::fill(z, 0.0);
  for (int s = 0; s < sweeps; ++s) sweep_forwards(level.matrix, level.diagonal, r, z);
  for (int s = 0; s < sweeps; ++s) sweep_backwards(level.matrix, level.diagonal, r, z);
}

void MultilevelCycle::cycle(std::size_t depth, std::span<const double> r, std::span<double> z) {
  if (depth + 1 == levels_.size()) return solve_coarsest(r, z);
  Level& level = levels_[depth];
  std::ranges::fill(z, 0.0);
  sweep_forwards(level.matrix, level.diagonal, r, z);
  multiply(level.matrix, z, level.residual);
  const SparseMatrix& p = level.prolongation;
  std::ranges::fill(level.coarse_right, 0.0);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t k = p.start[i]; k < p.start[i + 1]; ++k)
      level.coarse_right[p.column[k]] += p.value[k] * (r[i] - level.residual[i]);
  cycle(depth + 1, level.coarse_right, level.coarse_solution);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t k = p.start[i]; k < p.start[i + 1]; ++k)
      z[i] += p.value[k] * level.coarse_solution[p.column[k]];
  sweep_backwards(level.matrix, level.diagonal, r, z);
}

}  // namespace leonhard::graph::detail
