// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "leonhard/solver/linear_solver.hpp"
#include "tests/solver/session.hpp"

namespace {

using namespace leonhard;
using solver::BlockSystem;
using solver::LinearOutcome;
using solver::LinearReport;

/// A matrix of 4 x 4 blocks with its pattern; blocks of 16, column by column, as BlockSystem takes them.
struct Blocks {
  solver::BlockPattern pattern;
  std::vector<double> values;

  [[nodiscard]] std::size_t rows() const { return pattern.size(); }
  [[nodiscard]] std::vector<double> times(std::span<const double> x) const {
    std::vector<double> y(4 * rows());
    const double* block = values.data();
    for (std::size_t r = 0; r < rows(); ++r)
      for (const std::int32_t column : pattern[r]) {
        for (std::size_t j = 0; j < 4; ++j)
          for (std::size_t i = 0; i < 4; ++i)
            y[4 * r + i] += block[4 * j + i] * x[4 * static_cast<std::size_t>(column) + j];
        block += 16;
      }
    return y;
  }
};

/// Random blocks on the pattern where |row - column| is in `distances`, the diagonal dominant by `dominance`.
Blocks random_blocks(std::size_t rows, std::initializer_list<std::size_t> distances, double dominance,
                     std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Blocks a;
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < rows; ++c) {
      const std::size_t distance = r > c ? r - c : c - r;
      if (std::find(distances.begin(), distances.end(), distance) == distances.end()) continue;
      a.pattern.add_link(static_cast<std::int32_t>(c));
      for (std::size_t k = 0; k < 16; ++k)
        a.values.push_back(any(random) + (distance == 0 && k % 5 == 0 ? dominance : 0));
    }
    a.pattern.end_row();
  }
  return a;
}

std::vector<double> random_vector(std::size_t size, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<double> x(size);
  for (double& value : x) value = any(random);
  return x;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

TEST_CASE("block_tridiagonal_systems_are_solved_by_their_factors_alone") {
  test::start_petsc();
  const Blocks a = random_blocks(30, {0, 1}, 6, 1);  // ILU(0) drops nothing there
  const std::vector<double> exact = random_vector(4 * a.rows(), 2), b = a.times(exact);
  BlockSystem system(a.pattern);
  REQUIRE(system.factor(a.values));
  std::vector<double> x(b.size(), 7.0);  // what is in x does not matter
  const LinearReport report = system.solve(b, x, {1e-12, 30});
  CHECK(report.outcome == LinearOutcome::reached);
  CHECK(report.iterations == 1);
  CHECK(largest_difference(x, exact) < 1e-12);
}

TEST_CASE("systems_with_fill_are_solved_and_the_report_gives_the_true_residual") {
  test::start_petsc();
  const Blocks a = random_blocks(40, {0, 1, 5, 6}, 9, 3);
  const std::vector<double> exact = random_vector(4 * a.rows(), 4), b = a.times(exact);
  BlockSystem system(a.pattern);
  REQUIRE(system.factor(a.values));
  std::vector<double> x(b.size());
  const LinearReport report = system.solve(b, x, {1e-3, 60});
  CHECK(report.outcome == LinearOutcome::reached);
  CHECK(report.iterations > 1);
  std::vector<double> rest = a.times(x);
  double left = 0, whole = 0;
  for (std::size_t i = 0; i < b.size(); ++i)
    left += (b[i] - rest[i]) * (b[i] - rest[i]), whole += b[i] * b[i];
  CHECK(report.relative_residual == doctest::Approx(std::sqrt(left / whole)).epsilon(1e-6));
  CHECK(report.relative_residual <= 1e-3);
}

TEST_CASE("a_product_of_ones_own_takes_the_matrix_place_and_the_factors_precondition_it") {
  test::start_petsc();
  const Blocks a = random_blocks(25, {0, 1, 4}, 8, 5);
  const std::vector<double> exact = random_vector(4 * a.rows(), 6);
  const auto twice_plus = [&](std::span<const double> x) {  // 2 A + I
    std::vector<double> y = a.times(x);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = 2 * y[i] + x[i];
    return y;
  };
  BlockSystem system(a.pattern);
  REQUIRE(system.factor(a.values));
  std::vector<double> x(exact.size());
  const LinearReport report = system.solve(twice_plus(exact), x, {1e-12, 100},
                                           [&](std::span<const double> from, std::span<double> to) {
                                             const std::vector<double> y = twice_plus(from);
                                             std::copy(y.begin(), y.end(), to.begin());
                                           });
  CHECK(report.outcome == LinearOutcome::reached);
  CHECK(largest_difference(x, exact) < 1e-9);
}

TEST_CASE("an_iteration_limit_and_a_stop_are_outcomes") {
  test::start_petsc();
  const Blocks a = random_blocks(40, {0, 1, 5, 6}, 6, 7);
  const std::vector<double> b = random_vector(4 * a.rows(), 8);
  BlockSystem system(a.pattern);
  REQUIRE(system.factor(a.values));
  std::vector<double> x(b.size());
  const LinearReport limited = system.solve(b, x, {1e-14, 2});
  CHECK(limited.outcome == LinearOutcome::iteration_limit);
  CHECK(limited.iterations == 2);
  CHECK(limited.relative_residual < 1);
  std::stop_source source;
  source.request_stop();
  CHECK(system.solve(b, x, {1e-14, 30}, {}, source.get_token()).outcome == LinearOutcome::stopped);
}

TEST_CASE("a_singular_or_non_finite_pivot_block_is_refused_and_a_good_matrix_taken_after_it") {
  test::start_petsc();
  Blocks a = random_blocks(6, {0, 1}, 6, 9);
  BlockSystem system(a.pattern);
  Blocks bad = a;
  std::fill_n(bad.values.begin(), 16, 0.0);  // the first row's diagonal block
  CHECK_FALSE(system.factor(bad.values));
  bad = a;
  bad.values[0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(system.factor(bad.values));
  REQUIRE(system.factor(a.values));
  const std::vector<double> exact = random_vector(4 * a.rows(), 10), b = a.times(exact);
  std::vector<double> x(b.size());
  CHECK(system.solve(b, x, {1e-12, 30}).outcome == LinearOutcome::reached);
  CHECK(largest_difference(x, exact) < 1e-12);
}

TEST_CASE("what_a_product_throws_reaches_the_caller_and_the_system_stays_usable") {
  test::start_petsc();
  const Blocks a = random_blocks(12, {0, 1, 3}, 8, 11);
  const std::vector<double> exact = random_vector(4 * a.rows(), 12), b = a.times(exact);
  BlockSystem system(a.pattern);
  REQUIRE(system.factor(a.values));
  std::vector<double> x(b.size());
  int calls = 0;
  CHECK_THROWS_WITH_AS((void)system.solve(b, x, {1e-12, 30},
                                          [&](std::span<const double> from, std::span<double> to) {
                                            if (++calls == 1) throw std::domain_error("no such state");
                                            const std::vector<double> y = a.times(from);
                                            std::copy(y.begin(), y.end(), to.begin());
                                          }),
                       "no such state", std::domain_error);
  CHECK(calls == 1);
  CHECK(system.solve(b, x, {1e-12, 30}).outcome == LinearOutcome::reached);
  CHECK(largest_difference(x, exact) < 1e-11);
}

}  // namespace
