// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/stage.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>

#include "leonhard/kernel/arithmetic/small_multiples.hpp"
#include "leonhard/kernel/pair.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/kernel/stages/integer_predicates.hpp"
#include "tests/kernel/point_families.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using k::Pair;
using k::Stage;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

/// How often each stage answers over all families; each answer is checked.
using Tally = std::map<Stage, int>;

template <class Families, class Staged, class Oracle>
Tally tally(const Families& families, int calls_a_family, Staged staged, Oracle oracle) {
  Random random(81);
  calls_a_family = scaled_calls(calls_a_family);
  Tally counts;
  for (const auto& family : families) {
    CAPTURE(family.name);
    for (int i = 0; i < calls_a_family; ++i) {
      const auto points = family.draw(random);
      CAPTURE(as_source(points));
      const k::StagedSign answer = staged(points);
      REQUIRE(answer.sign == oracle(points));
      ++counts[answer.stage];
    }
  }
  return counts;
}

template <class Families, class Integers, class Oracle>
void check_integers(const Families& families, int calls_a_family, Integers integers, Oracle oracle) {
  Random random(82);
  calls_a_family = scaled_calls(calls_a_family);
  int answered = 0, ties = 0;
  for (const auto& family : families) {
    CAPTURE(family.name);
    for (int i = 0; i < calls_a_family; ++i) {
      const auto points = family.draw(random);
      CAPTURE(as_source(points));
      const std::optional<Sign> sign = integers(points);
      if (!sign) continue;
      REQUIRE(*sign == oracle(points));
      ++answered;
      ties += *sign == Sign::zero;
    }
  }
  CHECK(answered > calls_a_family * 8);
  CHECK(ties > 0);
}

}  // namespace

TEST_CASE("each_stage_of_the_predicates_of_the_plane_is_asked_and_right") {
  const Tally orient = tally(
      point_families(), 5'000, [](const Quadruple& q) { return k::orient2d_staged(q[0], q[1], q[2]); },
      [](const Quadruple& q) { return k::exact::orient2d(q[0], q[1], q[2]); });
  for (const Stage s : {Stage::filter, Stage::small_integer, Stage::integer, Stage::expansion,
                        Stage::wide_filter, Stage::wide_exact})
    CHECK(orient.contains(s));
  CHECK(orient.size() == 6);
  const Tally circle = tally(
      point_families(), 5'000, [](const Quadruple& q) { return k::incircle_staged(q[0], q[1], q[2], q[3]); },
      [](const Quadruple& q) { return k::exact::incircle(q[0], q[1], q[2], q[3]); });
  CHECK(circle.size() == 7);
  CHECK_FALSE(circle.contains(Stage::rational));
}

TEST_CASE("each_stage_of_the_predicates_of_space_is_asked_and_right") {
  const Tally orient = tally(
      point_families3(), 3'000, [](const Quintuple& q) { return k::orient3d_staged(q[0], q[1], q[2], q[3]); },
      [](const Quintuple& q) { return k::exact::orient3d(q[0], q[1], q[2], q[3]); });
  CHECK(orient.size() == 7);
  CHECK_FALSE(orient.contains(Stage::rational));
  const Tally sphere = tally(
      point_families3(), 3'000,
      [](const Quintuple& q) { return k::insphere_staged(q[0], q[1], q[2], q[3], q[4]); },
      [](const Quintuple& q) { return k::exact::insphere(q[0], q[1], q[2], q[3], q[4]); });
  CHECK(sphere.size() == 7);
  CHECK_FALSE(sphere.contains(Stage::rational));
}

TEST_CASE("integer_predicates_of_the_plane_agree_with_rational_arithmetic") {
  check_integers(
      point_families(), 10'000, [](const Quadruple& q) { return k::integer::orient2d(q[0], q[1], q[2]); },
      [](const Quadruple& q) { return k::exact::orient2d(q[0], q[1], q[2]); });
  check_integers(
      point_families(), 10'000,
      [](const Quadruple& q) { return k::integer::incircle(q[0], q[1], q[2], q[3]); },
      [](const Quadruple& q) { return k::exact::incircle(q[0], q[1], q[2], q[3]); });
}

TEST_CASE("integer_predicates_of_space_agree_with_rational_arithmetic") {
  check_integers(
      point_families3(), 5'000,
      [](const Quintuple& q) { return k::integer::orient3d(q[0], q[1], q[2], q[3]); },
      [](const Quintuple& q) { return k::exact::orient3d(q[0], q[1], q[2], q[3]); });
  check_integers(
      point_families3(), 5'000,
      [](const Quintuple& q) { return k::integer::insphere(q[0], q[1], q[2], q[3], q[4]); },
      [](const Quintuple& q) { return k::exact::insphere(q[0], q[1], q[2], q[3], q[4]); });
}

TEST_CASE("integer_predicates_take_the_largest_coordinates_they_may") {
  // Differences of all 62 bits: determinants near the 252 bits of incircle and the 317 bits of insphere.
  for (const double unit : {1.0, 0x1p-1074, 0x1p962}) {
    CAPTURE(unit);
    const double most = (0x1p61 - 0x1p8) * unit;
    const Point2 a{-most, -most}, b{most, -most}, c{most, most}, d{-most, most};
    CHECK(k::integer::orient2d(a, b, c) == Sign::positive);
    CHECK(k::integer::incircle(a, b, c, d) == Sign::zero);
    CHECK(k::integer::incircle(a, b, c, {-most, most - 0x1p8 * unit}) == Sign::positive);
    CHECK(k::integer::incircle(a, b, c, {0, unit}) == Sign::positive);
    const Point3 p{-most, -most, -most}, q{most, -most, -most}, r{-most, most, -most}, s{-most, -most, most};
    CHECK(k::integer::orient3d(p, q, r, s) == Sign::positive);
    CHECK(k::integer::insphere(p, q, r, s, {most, most, most}) == Sign::zero);
    CHECK(k::integer::insphere(p, q, r, s, {most, most, most - 0x1p8 * unit}) == Sign::positive);
    CHECK(k::integer::insphere(p, q, r, s, {0, 0, unit}) == Sign::positive);
  }
}

TEST_CASE("integer_predicates_leave_coordinates_of_distant_exponents_alone") {
  CHECK_FALSE(k::integer::orient2d({0x1p62, 0}, {0, 1}, {1, 0}).has_value());
  CHECK_FALSE(
      k::integer::orient2d({0x1p1000, 0}, {0, 0x1p-1074}, {1, 0}).has_value());  // 2^-1074, scaled, is 0
  CHECK_FALSE(k::integer::incircle({1e300, 0}, {0, 1e-300}, {1, 0}, {0, 0}).has_value());
  CHECK(k::integer::orient2d({-0.0, 0}, {0, -0.0}, {0, 0}) == Sign::zero);
}

TEST_CASE("small_multiples_are_recognised_at_every_scale_and_no_others") {
  const auto small = [](double x, double y, double z) {  // points (x, y) and (z, 0), their difference
    return k::are_small_multiples<4>(std::array{Pair{x - z, y}}, std::array{Pair{x, y}, Pair{z, 0}});
  };
  for (const double unit : {1.0, 0.125, 0x1p-180, 0x1p180}) {
    CAPTURE(unit);
    CHECK(small(16 * unit, -3 * unit, unit));
    CHECK(small(1000 * unit, unit, 999 * unit));
    CHECK_FALSE(small(16 * unit, -0.5 * unit, unit));  // a multiple of half a unit: five bits
    CHECK_FALSE(small(16 * unit, unit, 0.5 * unit));
  }
  CHECK_FALSE(small(0.1, 0.2, 0.3));
  CHECK_FALSE(small(0, 0, 0));                // no difference to measure by: left to the next stage
  CHECK_FALSE(small(0x1p-400, 0, 0));         // whose powers would underflow
  CHECK_FALSE(small(0x1p180, 0x1p-1074, 0));  // the second is a fraction of u that underflows
}
