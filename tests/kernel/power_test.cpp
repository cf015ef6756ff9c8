// SPDX-License-Identifier: MIT
#include "leonhard/kernel/power.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/weighted_families.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::WeightedPoint2;
using leonhard::WeightedPoint3;
using namespace leonhard::testing;

namespace {

constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

// ---- predicates of arrays ----

Sign power(const WeightedQuadruple& q) { return k::power_test(q[0], q[1], q[2], q[3]); }
Sign power(const WeightedQuintuple& q) { return k::power_test(q[0], q[1], q[2], q[3], q[4]); }
Sign perturbed(const WeightedQuadruple& q) { return k::power_test_perturbed(q[0], q[1], q[2], q[3]); }
Sign perturbed(const WeightedQuintuple& q) { return k::power_test_perturbed(q[0], q[1], q[2], q[3], q[4]); }
Sign in_ball(const Quadruple& q) { return k::incircle(q[0], q[1], q[2], q[3]); }
Sign in_ball(const Quintuple& q) { return k::insphere(q[0], q[1], q[2], q[3], q[4]); }
Sign in_ball_perturbed(const Quadruple& q) { return k::incircle_perturbed(q[0], q[1], q[2], q[3]); }
Sign in_ball_perturbed(const Quintuple& q) { return k::insphere_perturbed(q[0], q[1], q[2], q[3], q[4]); }

Sign oriented(const std::array<Point2, 3>& p) { return k::orient2d(p[0], p[1], p[2]); }
Sign oriented(const std::array<Point3, 4>& p) { return k::orient3d(p[0], p[1], p[2], p[3]); }

/// All on one line of the plane, or on one plane of space.
template <class Point, std::size_t Count>
bool all_flat(const std::array<Point, Count>& points) {
  for (std::size_t left_out = 0; left_out < Count; ++left_out) {
    std::array<Point, Count - 1> rest;
    for (std::size_t i = 0, j = 0; i < Count; ++i)
      if (i != left_out) rest[j++] = points[i];
    if (oriented(rest) != Sign::zero) return false;
  }
  return true;
}

/// Two of them have equal coordinates and, if asked for, weights.
template <class WeightedPoint, std::size_t Count>
bool any_equal(const std::array<WeightedPoint, Count>& points, bool weights_too) {
  for (std::size_t i = 0; i < Count; ++i)
    for (std::size_t j = i + 1; j < Count; ++j)
      if (points[i].point == points[j].point && (!weights_too || points[i].weight == points[j].weight))
        return true;
  return false;
}

/// check(points) for all families and kinds of weights.
template <class Families, class Check>
void for_all_weighted(unsigned seed, const Families& families, int calls, Check check) {
  Random random(seed);
  calls = scaled_calls(calls);
  for (const auto& family : families)
    for (int kind = 0; kind < weight_kinds; ++kind) {
      CAPTURE(family.name);
      CAPTURE(kind);
      for (int i = 0; i < calls; ++i) {
        const auto q = weigh(random, family.draw(random), kind);
        CAPTURE(as_source(q));
        check(q);
      }
    }
}

/// check(points) in the plane and in space.
template <class Check>
void for_all_weighted(unsigned seed, int calls, Check check) {
  for_all_weighted(seed, point_families(), calls, check);
  for_all_weighted(seed, point_families3(), calls, check);
}

template <std::size_t Count, class WeightedPoint>
std::array<WeightedPoint, Count> permuted(const std::array<WeightedPoint, Count>& q,
                                          const std::array<std::size_t, Count>& order) {
  std::array<WeightedPoint, Count> result;
  for (std::size_t i = 0; i < Count; ++i) result[i] = q[order[i]];
  return result;
}

}  // namespace

TEST_CASE("power_test_of_the_plane_agrees_with_rational_arithmetic") {
  int ties = 0;
  for_all_weighted(101, point_families(), 800, [&ties](const WeightedQuadruple& q) {
    const Sign truth = k::exact::power_test(q[0], q[1], q[2], q[3]);
    ties += truth == Sign::zero;
    REQUIRE(power(q) == truth);
    REQUIRE(k::power_test_exact(q[0], q[1], q[2], q[3]) == truth);
  });
  CHECK(ties > scaled_calls(1500));
}

TEST_CASE("power_test_of_space_agrees_with_rational_arithmetic") {
  int ties = 0;
  for_all_weighted(102, point_families3(), 400, [&ties](const WeightedQuintuple& q) {
    const Sign truth = k::exact::power_test(q[0], q[1], q[2], q[3], q[4]);
    ties += truth == Sign::zero;
    REQUIRE(power(q) == truth);
    REQUIRE(k::power_test_exact(q[0], q[1], q[2], q[3], q[4]) == truth);
  });
  CHECK(ties > scaled_calls(1500));
}

TEST_CASE("compare_power_distance_agrees_with_rational_arithmetic") {
  int ties = 0;
  for_all_weighted(103, 500, [&ties](const auto& q) {
    const Sign truth = k::exact::compare_power_distance(q[0].point, q[1], q[2]);
    ties += truth == Sign::zero;
    REQUIRE(k::compare_power_distance(q[0].point, q[1], q[2]) == truth);
    REQUIRE(k::compare_power_distance_exact(q[0].point, q[1], q[2]) == truth);
    REQUIRE(k::compare_power_distance(q[0].point, q[2], q[1]) == -truth);
  });
  CHECK(ties > scaled_calls(300));
}

TEST_CASE("predicates_of_weighted_points_have_the_documented_signs") {
  const WeightedPoint2 a{{0, 0}, 0}, b{{4, 0}, 0}, c{{0, 4}, 0};
  REQUIRE(k::orient2d(a.point, b.point, c.point) == Sign::positive);
  // The orthogonal circle has centre (2, 2) and squared radius 8; the power of (6, 2) to it is 16 - 8 - w.
  CHECK(k::power_test(a, b, c, {{6, 2}, 7}) == Sign::negative);
  CHECK(k::power_test(a, b, c, {{6, 2}, 8}) == Sign::zero);
  CHECK(k::power_test(a, b, c, {{6, 2}, 9}) == Sign::positive);
  CHECK(k::power_test(a, c, b, {{6, 2}, 9}) == Sign::negative);
  CHECK(k::power_test(a, b, c, {{2, 2}, -8}) == Sign::zero);
  CHECK(k::power_test(a, b, c, {{2, 2}, -9}) == Sign::negative);

  const WeightedPoint3 o{{0, 0, 0}, 0}, x{{2, 0, 0}, 0}, y{{0, 2, 0}, 0}, z{{0, 0, 2}, 0};
  // Centre (1, 1, 1), squared radius 3; the power of (3, 1, 1) is 4 - 3 - w.
  CHECK(k::power_test(o, x, y, z, {{3, 1, 1}, 0.5}) == Sign::negative);
  CHECK(k::power_test(o, x, y, z, {{3, 1, 1}, 1}) == Sign::zero);
  CHECK(k::power_test(o, x, y, z, {{3, 1, 1}, 1.5}) == Sign::positive);

  CHECK(k::compare_power_distance(Point2{0, 0}, {{3, 0}, 5}, {{0, 2}, 0}) == Sign::zero);
  CHECK(k::compare_power_distance(Point2{0, 0}, {{3, 0}, 4}, {{0, 2}, 0}) == Sign::positive);
  CHECK(k::compare_power_distance(Point3{0, 0, 0}, {{3, 0, 0}, 6}, {{0, 0, 2}, 0}) == Sign::negative);
}

TEST_CASE("power_test_sees_the_smallest_weight_beside_the_largest_coordinates") {
  const auto square = [](double size, double weight) {
    return WeightedQuadruple{
        {{{-size, -size}, 0}, {{size, -size}, 0}, {{size, size}, 0}, {{-size, size}, weight}}};
  };
  for (const double size : {1.0, 0.1, 1e-200, 1e200, smallest, largest}) {
    CAPTURE(size);
    CHECK(power(square(size, 0)) == Sign::zero);
    CHECK(power(square(size, smallest)) == Sign::positive);
    CHECK(power(square(size, -smallest)) == Sign::negative);
    CHECK(power(square(size, largest)) == Sign::positive);
  }
}

TEST_CASE("power_test_keeps_weights_whose_differences_overflow") {
  const WeightedPoint2 a{{0, 0}, -largest}, b{{1, 0}, -largest}, c{{0, 1}, -largest};
  CHECK(k::power_test(a, b, c, {{1e100, 3e150}, largest}) == Sign::positive);
  CHECK(k::power_test(a, b, c, {{1e200, 3e150}, largest}) == Sign::negative);
  CHECK(k::power_test(a, b, c, {{1, 1}, -largest}) == Sign::zero);
  CHECK(k::power_test(a, b, c, {{1, 1 - 0x1p-53}, -largest}) == Sign::positive);
}

TEST_CASE("power_test_is_not_fooled_by_minors_that_underflow_beside_huge_weights") {
  // The minors are a few smallest numbers, and wrong by as much; the weights bring the error up to 2^-60 or
  // so.
  Random random(104);
  const int calls = scaled_calls(20'000);
  for (int i = 0; i < calls; ++i) {
    const auto points = each_coordinate([&random] { return any_exponent(random, -539, -535); });
    WeightedQuadruple q;
    for (std::size_t j = 0; j < 4; ++j) q[j] = {points[j], any_exponent(random, 1000, 1023)};
    CAPTURE(as_source(q));
    REQUIRE(power(q) == k::exact::power_test(q[0], q[1], q[2], q[3]));
    const auto points3 = each_coordinate3([&random] { return any_exponent(random, -360, -356); });
    WeightedQuintuple r;
    for (std::size_t j = 0; j < 5; ++j) r[j] = {points3[j], any_exponent(random, 1000, 1023)};
    CAPTURE(as_source(r));
    REQUIRE(power(r) == k::exact::power_test(r[0], r[1], r[2], r[3], r[4]));
  }
}

TEST_CASE("power_test_keeps_the_last_bits_of_weights_whose_products_underflow") {
  // Corners of a rectangle, lifted to one plane but for the last bits of their weights.
  Random random(111);
  for (int i = 0; i < 20'000; ++i) {
    const auto coordinate = [&random] { return 0x1p-205 * uniform(random); };
    const double left = coordinate(), right = coordinate(), bottom = coordinate(), top = coordinate();
    const Quadruple points{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}};
    const Plane plane(random);
    WeightedQuadruple q;
    for (std::size_t j = 0; j < 4; ++j) q[j] = {points[j], nudge(random, std::ldexp(plane(points[j]), -315))};
    CAPTURE(as_source(q));
    REQUIRE(power(q) == k::exact::power_test(q[0], q[1], q[2], q[3]));
  }
}

TEST_CASE("power_test_of_equal_weights_is_incircle_or_insphere") {
  Random random(105);
  const int calls = scaled_calls(500);
  const auto check = [&random, calls](const auto& families) {
    for (const auto& family : families)
      for (int i = 0; i < calls; ++i) {
        const auto points = family.draw(random);
        CAPTURE(as_source(points));
        for (const double weight : {0.0, 1.0, -largest, any_exponent(random, -1074, 1024)}) {
          CAPTURE(weight);
          const auto q = with_equal_weights(points, weight);
          REQUIRE(power(q) == in_ball(points));
          REQUIRE(perturbed(q) == in_ball_perturbed(points));
          REQUIRE(k::compare_power_distance(points[0], q[1], q[2]) ==
                  k::compare_distance(points[0], points[1], points[2]));
        }
      }
  };
  check(point_families());
  check(point_families3());
}

TEST_CASE("power_test_follows_the_sign_of_every_permutation") {
  for_all_weighted(106, 5, [](const auto& q) {
    const Sign s = power(q), t = perturbed(q);
    std::array<std::size_t, std::tuple_size_v<std::decay_t<decltype(q)>>> order;
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    do {
      REQUIRE(power(permuted(q, order)) == permutation_sign(order) * s);
      REQUIRE(perturbed(permuted(q, order)) == permutation_sign(order) * t);
    } while (std::ranges::next_permutation(order).found);
  });
}

TEST_CASE("power_test_does_not_change_if_all_points_move_or_all_weights_grow") {
  Random random(107);
  for (int i = 0; i < 5000; ++i) {
    WeightedQuadruple q, moved;
    for (std::size_t j = 0; j < 4; ++j) {
      q[j] = {{double(integer(random, -5, 5)), double(integer(random, -5, 5))},
              double(integer(random, -9, 9))};
      moved[j] = {{q[j].point.x + 1e6, q[j].point.y - 3e5}, q[j].weight + 1e9};
    }
    REQUIRE(power(q) == power(moved));
  }
}

TEST_CASE("perturbed_power_test_is_power_test_where_that_is_not_zero_and_else_breaks_the_tie") {
  int ties = 0;
  for_all_weighted(108, 250, [&ties](const auto& q) {
    const Sign s = power(q);
    if (s != Sign::zero) {
      REQUIRE(perturbed(q) == s);
    } else if (any_equal(q, false) || all_flat(points_of(q))) {
      REQUIRE(perturbed(q) == Sign::zero);
    } else {
      ++ties;
      REQUIRE(perturbed(q) != Sign::zero);
    }
  });
  CHECK(ties > scaled_calls(1000));
}

TEST_CASE("two_equal_points_tie_only_with_equal_weights_or_if_all_are_flat") {
  for_all_weighted(109, 100, [](auto q) {
    q[1].point = q[0].point;
    if (any_equal(q, true) || all_flat(points_of(q))) {
      REQUIRE(perturbed(q) == Sign::zero);
      return;
    }
    bool others_equal = false;
    for (std::size_t i = 1; i < q.size(); ++i)
      for (std::size_t j = i + 1; j < q.size(); ++j) others_equal |= q[i].point == q[j].point;
    if (!others_equal) REQUIRE(power(q) != Sign::zero);
  });
}

TEST_CASE("the_filters_of_weighted_points_decide_nearly_all_uniform_ones") {
  Random random(110);
  int undecided = 0;
  for (int i = 0; i < 50'000; ++i) {
    const auto [a, b, c, d] = weigh(random, each_coordinate([&random] { return uniform(random); }), 2);
    undecided += !k::power_test_filter(a, b, c, d).is_certain();
    undecided += !k::compare_power_distance_filter(a.point, b, c).is_certain();
    const auto q = weigh(random, each_coordinate3([&random] { return uniform(random); }), 2);
    undecided += !k::power_test_filter(q[0], q[1], q[2], q[3], q[4]).is_certain();
    undecided += !k::compare_power_distance_filter(q[0].point, q[1], q[2]).is_certain();
  }
  CHECK(undecided == 0);
}
