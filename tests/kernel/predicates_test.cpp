// SPDX-License-Identifier: MIT
#include "leonhard/kernel/predicates.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

/// Checks a predicate and its exact part on all families; 304 000 calls of the oracle.
template <class Predicate, class Exact, class Oracle>
void check_against_oracle(Predicate predicate, Exact exact_part, Oracle oracle) {
  Random random(20240229);
  const int calls_a_family = scaled_calls(16'000);
  for (const PointFamily& family : point_families()) {
    CAPTURE(family.name);
    for (int i = 0; i < calls_a_family; ++i) {
      const Quadruple q = family.draw(random);
      const Sign truth = oracle(q);
      if (predicate(q) == truth && exact_part(q) == truth) continue;
      CAPTURE(as_source(q));
      CHECK(predicate(q) == truth);
      REQUIRE(exact_part(q) == truth);
    }
  }
}

constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

}  // namespace

TEST_CASE("orient2d_agrees_with_rational_arithmetic") {
  check_against_oracle([](const Quadruple& q) { return k::orient2d(q[0], q[1], q[2]); },
                       [](const Quadruple& q) { return k::orient2d_exact(q[0], q[1], q[2]); },
                       [](const Quadruple& q) { return k::exact::orient2d(q[0], q[1], q[2]); });
}

TEST_CASE("incircle_agrees_with_rational_arithmetic") {
  check_against_oracle([](const Quadruple& q) { return k::incircle(q[0], q[1], q[2], q[3]); },
                       [](const Quadruple& q) { return k::incircle_exact(q[0], q[1], q[2], q[3]); },
                       [](const Quadruple& q) { return k::exact::incircle(q[0], q[1], q[2], q[3]); });
}

TEST_CASE("in_diametral_circle_agrees_with_rational_arithmetic") {
  check_against_oracle([](const Quadruple& q) { return k::in_diametral_circle(q[0], q[1], q[2]); },
                       [](const Quadruple& q) { return k::in_diametral_circle_exact(q[0], q[1], q[2]); },
                       [](const Quadruple& q) { return k::exact::in_diametral_circle(q[0], q[1], q[2]); });
}

TEST_CASE("compare_distance_agrees_with_rational_arithmetic") {
  check_against_oracle([](const Quadruple& q) { return k::compare_distance(q[0], q[1], q[2]); },
                       [](const Quadruple& q) { return k::compare_distance_exact(q[0], q[1], q[2]); },
                       [](const Quadruple& q) { return k::exact::compare_distance(q[0], q[1], q[2]); });
}

TEST_CASE("predicates_have_the_documented_signs") {
  const Point2 a{0, 0}, b{1, 0}, c{0, 1};
  CHECK(k::orient2d(a, b, c) == Sign::positive);
  CHECK(k::orient2d(a, b, {2, 0}) == Sign::zero);
  CHECK(k::incircle(a, b, c, {0.5, 0.5}) == Sign::positive);
  CHECK(k::incircle(a, b, c, {1, 1}) == Sign::zero);
  CHECK(k::incircle(a, b, c, {2, 2}) == Sign::negative);
  CHECK(k::incircle(a, c, b, {2, 2}) == Sign::positive);
  CHECK(k::in_diametral_circle({0.5, 0.1}, a, b) == Sign::positive);
  CHECK(k::in_diametral_circle({0.5, 0.5}, a, b) == Sign::zero);
  CHECK(k::in_diametral_circle({0.5, 0.6}, a, b) == Sign::negative);
  CHECK(k::in_diametral_circle(a, a, b) == Sign::zero);
  CHECK(k::compare_distance(a, {2, 0}, {0, 1}) == Sign::positive);
  CHECK(k::compare_distance(a, {3, 4}, {5, 0}) == Sign::zero);
}

TEST_CASE("orient2d_sees_the_smallest_triangle_there_is") {
  CHECK(k::orient2d({0, 0}, {0, smallest}, {smallest, 0}) == Sign::negative);
  CHECK(k::orient2d({0, 0}, {smallest, 0}, {0, smallest}) == Sign::positive);
  CHECK(k::orient2d({0, 0}, {smallest, smallest}, {2 * smallest, 2 * smallest}) == Sign::zero);
}

TEST_CASE("incircle_sees_the_smallest_circle_there_is") {
  const Point2 a{0, 0}, b{2 * smallest, 0}, c{2 * smallest, 2 * smallest};
  CHECK(k::incircle(a, b, c, {smallest, smallest}) == Sign::positive);
  CHECK(k::incircle(a, b, c, {0, 2 * smallest}) == Sign::zero);
  CHECK(k::incircle(a, b, c, {0, 3 * smallest}) == Sign::negative);
}

TEST_CASE("predicates_survive_differences_that_overflow") {
  CHECK(k::orient2d({-largest, -largest}, {largest, -largest}, {largest, largest}) == Sign::positive);
  CHECK(k::orient2d({-largest, -largest}, {0, 0}, {largest, largest}) == Sign::zero);
  CHECK(k::orient2d({-largest, -largest}, {smallest, 0}, {largest, largest}) == Sign::positive);
  const Point2 a{-largest, -largest}, b{largest, -largest}, c{largest, largest};
  CHECK(k::incircle(a, b, c, {-largest, largest}) == Sign::zero);
  CHECK(k::incircle(a, b, c, {0, smallest}) == Sign::positive);
  CHECK(k::in_diametral_circle(b, a, c) == Sign::zero);
  CHECK(k::compare_distance({0, 0}, a, c) == Sign::zero);
  CHECK(k::compare_distance({smallest, 0}, a, c) == Sign::positive);
}

TEST_CASE("negative_zero_is_zero") {
  CHECK(k::orient2d({-0.0, 0}, {0, -0.0}, {1, 1}) == Sign::zero);
  CHECK(k::incircle({-0.0, -0.0}, {1, -0.0}, {1, 1}, {-0.0, 1}) == Sign::zero);
  CHECK(k::exact::orient2d({-0.0, 0}, {1, -0.0}, {0, 1}) == Sign::positive);
}

TEST_CASE("orient2d_flips_sign_under_every_swap_and_keeps_it_under_rotation") {
  Random random(7);
  const int calls = scaled_calls(2000);
  for (const PointFamily& family : point_families())
    for (int i = 0; i < calls; ++i) {
      const Quadruple q = family.draw(random);
      const auto& [a, b, c, unused] = q;
      const Sign s = k::orient2d(a, b, c);
      CAPTURE(as_source(q));
      REQUIRE(k::orient2d(b, c, a) == s);
      REQUIRE(k::orient2d(c, a, b) == s);
      REQUIRE(k::orient2d(b, a, c) == -s);
      REQUIRE(k::orient2d(a, c, b) == -s);
      REQUIRE(k::orient2d(c, b, a) == -s);
    }
}

TEST_CASE("incircle_follows_the_sign_of_every_permutation") {
  Random random(8);
  const int calls = scaled_calls(1000);
  for (const PointFamily& family : point_families())
    for (int i = 0; i < calls; ++i) {
      const Quadruple q = family.draw(random);
      const Sign s = k::incircle(q[0], q[1], q[2], q[3]);
      std::array<std::size_t, 4> p{0, 1, 2, 3};
      do {
        int inversions = 0;
        for (std::size_t j = 0; j < 4; ++j)
          for (std::size_t l = j + 1; l < 4; ++l) inversions += p[j] > p[l];
        const Sign expected = inversions % 2 == 0 ? s : -s;
        CAPTURE(as_source(q));
        REQUIRE(k::incircle(q[p[0]], q[p[1]], q[p[2]], q[p[3]]) == expected);
      } while (std::ranges::next_permutation(p).found);
    }
}

TEST_CASE("the_filters_decide_nearly_all_uniform_points") {
  Random random(9);
  int undecided = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto [a, b, c, d] = each_coordinate([&random] { return uniform(random); });
    undecided += !k::orient2d_filter(a, b, c).is_certain();
    undecided += !k::incircle_filter(a, b, c, d).is_certain();
    undecided += !k::in_diametral_circle_filter(a, b, c).is_certain();
    undecided += !k::compare_distance_filter(a, b, c).is_certain();
  }
  CHECK(undecided == 0);
}

TEST_CASE("compare_xy_is_lexicographic") {
  CHECK(k::compare_xy({0, 5}, {1, 0}) == Sign::negative);
  CHECK(k::compare_xy({1, 5}, {1, 0}) == Sign::positive);
  CHECK(k::compare_xy({1, 0x1p-1074}, {1, 0}) == Sign::positive);
  CHECK(k::compare_xy({0, -0.0}, {-0.0, 0}) == Sign::zero);
}

TEST_CASE("angles_of_the_plane_are_told_apart_by_one_bit") {
  const double above = std::nextafter(1.0, 2.0), below = std::nextafter(1.0, 0.0);
  CHECK(k::angle({1, 1}, {0, 0}, {-1, 1}) == Sign::zero);
  CHECK(k::angle({1, 1}, {0, 0}, {-1, above}) == Sign::positive);
  CHECK(k::angle({1, 1}, {0, 0}, {-1, below}) == Sign::negative);
  CHECK(k::angle({1e300, 1e-300}, {0, 0}, {-1e-300, 1e300}) == Sign::zero);
  CHECK(k::angle({0, 0}, {0, 0}, {1, 0}) == Sign::zero);
}
