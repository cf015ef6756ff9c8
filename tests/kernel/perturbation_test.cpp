// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <gmpxx.h>
#include <algorithm>
#include <array>
#include <cstddef>

#include "leonhard/kernel/predicates.hpp"
#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

bool distinct(Quadruple q) {
  std::ranges::sort(q, [](const Point2& a, const Point2& b) { return a < b; });
  return std::ranges::adjacent_find(q) == q.end();
}

Sign perturbed(const Quadruple& q) { return k::incircle_perturbed(q[0], q[1], q[2], q[3]); }

/// The definition itself: points lifted to x^2 + y^2 + h, with heights so far apart that each outweighs all below
/// it, exactly. Good for integers up to 1000, whose determinants lie below 2^60.
Sign lifted_incircle(const Quadruple& q) {
  std::array<std::size_t, 4> rank{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) rank[i] += q[j] < q[i];
  std::array<mpq_class, 4> lifted;
  for (std::size_t i = 0; i < 4; ++i) {
    const mpz_class height_inverse = mpz_class(1) << (100 * (4 - rank[i]));
    lifted[i] = mpq_class(q[i].x) * q[i].x + mpq_class(q[i].y) * q[i].y + mpq_class(1, height_inverse);
  }
  mpq_class determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 p = q[(i + 1) % 3], r = q[(i + 2) % 3];
    const mpq_class minor =
        mpq_class(p.x - q[3].x) * (r.y - q[3].y) - mpq_class(p.y - q[3].y) * (r.x - q[3].x);
    determinant += (lifted[i] - lifted[3]) * minor;
  }
  // The determinant of rows (x, y, lift) - (x, y, lift)_d equals incircle's: translating the paraboloid's origin adds
  // multiples of the other columns.
  return leonhard::sign_of(determinant);
}

}  // namespace

TEST_CASE("perturbed_incircle_is_incircle_where_that_is_not_zero") {
  Random random(31);
  const int calls = scaled_calls(5000);
  for (const PointFamily& family : point_families())
    for (int i = 0; i < calls; ++i) {
      const Quadruple q = family.draw(random);
      const Sign s = k::incircle(q[0], q[1], q[2], q[3]);
      CAPTURE(as_source(q));
      if (s != Sign::zero) REQUIRE(perturbed(q) == s);
    }
}

TEST_CASE("perturbed_incircle_is_never_zero_for_a_triangle_and_another_point") {
  Random random(32);
  int ties = 0;
  const int calls = scaled_calls(5000);
  for (const PointFamily& family : point_families())
    for (int i = 0; i < calls; ++i) {
      const Quadruple q = family.draw(random);
      if (!distinct(q) || k::orient2d(q[0], q[1], q[2]) == Sign::zero) continue;
      ties += k::incircle(q[0], q[1], q[2], q[3]) == Sign::zero;
      CAPTURE(as_source(q));
      REQUIRE(perturbed(q) != Sign::zero);
    }
  CHECK(ties > calls / 2);
}

TEST_CASE("perturbed_incircle_follows_the_sign_of_every_permutation") {
  Random random(33);
  const int calls = scaled_calls(1000);
  for (const PointFamily& family : point_families())
    for (int i = 0; i < calls; ++i) {
      const Quadruple q = family.draw(random);
      const Sign s = perturbed(q);
      CAPTURE(as_source(q));
      for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t l = j + 1; l < 4; ++l) {
          Quadruple swapped = q;
          std::swap(swapped[j], swapped[l]);
          REQUIRE(perturbed(swapped) == -s);
        }
    }
}

TEST_CASE("perturbed_incircle_equals_incircle_of_lifted_points") {
  Random random(34);
  for (int i = 0; i < 20'000; ++i) {
    const int size = i % 2 == 0 ? 2 : 1000;
    const Quadruple q = each_coordinate([&] { return double(integer(random, -size, size)); });
    if (!distinct(q)) continue;
    CAPTURE(as_source(q));
    REQUIRE(perturbed(q) == lifted_incircle(q));
  }
}

TEST_CASE("perturbed_incircle_gives_a_square_one_diagonal_whatever_triangle_asks") {
  const Point2 a{0, 0}, b{1, 0}, c{1, 1}, d{0, 1};
  // Either d is outside abc and b outside cda, or each is inside: never one of both.
  CHECK(k::incircle_perturbed(a, b, c, d) == k::incircle_perturbed(c, d, a, b));
  CHECK(k::incircle_perturbed(b, c, d, a) == -k::incircle_perturbed(a, b, c, d));
}

TEST_CASE("perturbed_incircle_of_repeated_or_collinear_points_is_zero") {
  CHECK(k::incircle_perturbed({0, 0}, {1, 0}, {0, 1}, {1, 0}) == Sign::zero);
  CHECK(k::incircle_perturbed({0, 0}, {0, -0.0}, {0, 1}, {1, 0}) == Sign::zero);
  CHECK(k::incircle_perturbed({0, 0}, {1, 1}, {2, 2}, {3, 3}) == Sign::zero);
}
