// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <gmpxx.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "leonhard/kernel/predicates3.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using leonhard::Point3;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

bool distinct(Quintuple q) {
  std::ranges::sort(q, [](const Point3& a, const Point3& b) { return a < b; });
  return std::ranges::adjacent_find(q) == q.end();
}

Sign tie_of(const Quintuple& q) { return k::insphere(q[0], q[1], q[2], q[3], q[4]); }
Sign perturbed(const Quintuple& q) { return k::insphere_perturbed(q[0], q[1], q[2], q[3], q[4]); }

bool all_coplanar(const Quintuple& q) {
  for (std::size_t left_out = 0; left_out < 5; ++left_out) {
    std::array<Point3, 4> rest;
    for (std::size_t i = 0, j = 0; i < 5; ++i)
      if (i != left_out) rest[j++] = q[i];
    if (k::orient3d(rest[0], rest[1], rest[2], rest[3]) != Sign::zero) return false;
  }
  return true;
}

/// The determinant of a square matrix of rationals, by elimination.
template <std::size_t N>
mpq_class determinant(std::array<std::array<mpq_class, N>, N> m) {
  mpq_class product = 1;
  for (std::size_t column = 0; column < N; ++column) {
    std::size_t pivot = column;
    while (pivot < N && m[pivot][column] == 0) ++pivot;
    if (pivot == N) return 0;
    if (pivot != column) {
      std::swap(m[pivot], m[column]);
      product = -product;
    }
    product *= m[column][column];
    for (std::size_t row = column + 1; row < N; ++row) {
      const mpq_class factor = m[row][column] / m[column][column];
      for (std::size_t j = column; j < N; ++j) m[row][j] -= factor * m[column][j];
    }
  }
  return product;
}

/// The definition itself: points lifted to x^2 + y^2 + z^2 + h, with heights so far apart that each outweighs all below
/// it, exactly. Good for integers up to 1000, whose determinants lie below 2^80.
Sign lifted_insphere(const Quintuple& q) {
  std::array<std::array<mpq_class, 5>, 5> rows;
  for (std::size_t i = 0; i < 5; ++i) {
    unsigned rank = 0;
    for (std::size_t j = 0; j < 5; ++j) rank += q[j] < q[i];
    const mpz_class height_inverse = mpz_class(1) << (100 * (5 - rank));
    const mpq_class x = q[i].x, y = q[i].y, z = q[i].z;
    rows[i] = {x, y, z, x * x + y * y + z * z + mpq_class(1, height_inverse), 1};
  }
  // Rows (x, y, z, lift, 1) make Shewchuk's determinant, whose orientation is the opposite of ours.
  return -leonhard::sign_of(determinant(rows));
}

}  // namespace

TEST_CASE("perturbed_insphere_is_insphere_where_that_is_not_zero") {
  Random random(81);
  const int calls = scaled_calls(2000);
  for (const PointFamily3& family : point_families3())
    for (int i = 0; i < calls; ++i) {
      const Quintuple q = family.draw(random);
      const Sign s = tie_of(q);
      CAPTURE(as_source(q));
      if (s != Sign::zero) REQUIRE(perturbed(q) == s);
    }
}

TEST_CASE("perturbed_insphere_is_zero_only_for_equal_or_coplanar_points") {
  Random random(82);
  int ties = 0;
  const int calls = scaled_calls(2000);
  for (const PointFamily3& family : point_families3())
    for (int i = 0; i < calls; ++i) {
      const Quintuple q = family.draw(random);
      CAPTURE(as_source(q));
      if (!distinct(q) || all_coplanar(q)) {
        REQUIRE(perturbed(q) == Sign::zero);
        continue;
      }
      ties += tie_of(q) == Sign::zero;
      REQUIRE(perturbed(q) != Sign::zero);
    }
  CHECK(ties > calls / 2);
}

TEST_CASE("perturbed_insphere_follows_the_sign_of_every_swap") {
  Random random(83);
  const int calls = scaled_calls(500);
  for (const PointFamily3& family : point_families3())
    for (int i = 0; i < calls; ++i) {
      const Quintuple q = family.draw(random);
      const Sign s = perturbed(q);
      CAPTURE(as_source(q));
      for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t l = j + 1; l < 5; ++l) {
          Quintuple swapped = q;
          std::swap(swapped[j], swapped[l]);
          REQUIRE(perturbed(swapped) == -s);
        }
    }
}

TEST_CASE("perturbed_insphere_equals_insphere_of_lifted_points") {
  Random random(84);
  for (int i = 0; i < 20'000; ++i) {
    const int size = i % 2 == 0 ? 1 : 1000;
    const Quintuple q = each_coordinate3([&] { return double(integer(random, -size, size)); });
    if (!distinct(q)) continue;
    CAPTURE(as_source(q));
    REQUIRE(perturbed(q) == lifted_insphere(q));
  }
}

TEST_CASE("perturbed_insphere_lets_two_tetrahedra_of_a_cube_agree_about_each_other") {
  // Two tetrahedra on either side of the triangle b, c, d: each finds the other's apex outside, or each inside.
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1}, e{1, 1, 1};
  REQUIRE(k::orient3d(a, b, c, d) == Sign::positive);
  REQUIRE(k::orient3d(e, b, d, c) == Sign::positive);
  REQUIRE(k::insphere(a, b, c, d, e) == Sign::zero);
  CHECK(k::insphere_perturbed(a, b, c, d, e) != Sign::zero);
  CHECK(k::insphere_perturbed(a, b, c, d, e) == k::insphere_perturbed(e, b, d, c, a));
}

TEST_CASE("perturbed_insphere_of_repeated_or_coplanar_points_is_zero") {
  const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(k::insphere_perturbed(o, x, y, z, y) == Sign::zero);
  CHECK(k::insphere_perturbed(o, x, y, z, {0, -0.0, 0}) == Sign::zero);
  CHECK(k::insphere_perturbed(o, x, y, {1, 1, 0}, {3, 2, 0}) == Sign::zero);
}
