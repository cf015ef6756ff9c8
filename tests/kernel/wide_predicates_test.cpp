// SPDX-License-Identifier: MIT
#include "leonhard/kernel/stages/wide_predicates.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/point_families.hpp"
#include "tests/kernel/point_families3.hpp"
#include "tests/kernel/weighted_families.hpp"

namespace k = leonhard::kernel;
namespace w = leonhard::kernel::wide_range;
using k::Stage;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

/// Checks a predicate on points of all kinds, whether or not earlier stages would answer them, and that it finds no tie
/// in floating point.
template <class Families, class Staged, class Oracle>
void check_stages(const Families& families, int calls_a_family, Staged staged, Oracle oracle) {
  Random random(94);
  std::map<Stage, int> answered;
  calls_a_family = scaled_calls(calls_a_family);
  for (const auto& family : families) {
    CAPTURE(family.name);
    for (int i = 0; i < calls_a_family; ++i) {
      const auto points = family.draw(random);
      CAPTURE(as_source(points));
      const k::StagedSign answer = staged(points);
      REQUIRE(answer.sign == oracle(points));
      ++answered[answer.stage];
    }
  }
  CHECK(answered.size() == 2);
  CHECK(answered[Stage::wide_filter] > calls_a_family * 8);
  CHECK(answered[Stage::wide_exact] > calls_a_family * 2);
}

template <class Families, class Predicate, class Oracle>
void check_signs(const Families& families, int calls_a_family, Predicate predicate, Oracle oracle) {
  Random random(95);
  calls_a_family = scaled_calls(calls_a_family);
  for (const auto& family : families) {
    CAPTURE(family.name);
    for (int i = 0; i < calls_a_family; ++i) {
      const auto points = family.draw(random);
      CAPTURE(as_source(points));
      REQUIRE(predicate(points) == oracle(points));
    }
  }
}

/// Numbers whose mantissas are close below 2: sums of their products come near the size that error bounds reckon with.
double almost_a_power_of_two(Random& random, int spread) {
  const double size = std::ldexp(uniform(random, 1.9, 2), integer(random, -spread, spread));
  return integer(random, 0, 1) == 0 ? size : -size;
}

}  // namespace

TEST_CASE("wide_predicates_of_the_plane_agree_with_rational_arithmetic") {
  check_stages(
      point_families(), 2'000, [](const Quadruple& q) { return w::orient2d(q[0], q[1], q[2]); },
      [](const Quadruple& q) { return k::exact::orient2d(q[0], q[1], q[2]); });
  check_stages(
      point_families(), 2'000, [](const Quadruple& q) { return w::incircle(q[0], q[1], q[2], q[3]); },
      [](const Quadruple& q) { return k::exact::incircle(q[0], q[1], q[2], q[3]); });
  check_signs(
      point_families(), 500, [](const Quadruple& q) { return w::in_diametral_circle(q[0], q[1], q[2]); },
      [](const Quadruple& q) { return k::exact::in_diametral_circle(q[0], q[1], q[2]); });
  check_signs(
      point_families(), 500, [](const Quadruple& q) { return w::compare_distance(q[0], q[1], q[2]); },
      [](const Quadruple& q) { return k::exact::compare_distance(q[0], q[1], q[2]); });
}

TEST_CASE("wide_predicates_of_space_agree_with_rational_arithmetic") {
  check_stages(
      point_families3(), 1'000, [](const Quintuple& q) { return w::orient3d(q[0], q[1], q[2], q[3]); },
      [](const Quintuple& q) { return k::exact::orient3d(q[0], q[1], q[2], q[3]); });
  check_stages(
      point_families3(), 1'000, [](const Quintuple& q) { return w::insphere(q[0], q[1], q[2], q[3], q[4]); },
      [](const Quintuple& q) { return k::exact::insphere(q[0], q[1], q[2], q[3], q[4]); });
  check_signs(
      point_families3(), 500, [](const Quintuple& q) { return w::in_diametral_sphere(q[0], q[1], q[2]); },
      [](const Quintuple& q) { return k::exact::in_diametral_sphere(q[0], q[1], q[2]); });
  check_signs(
      point_families3(), 500, [](const Quintuple& q) { return w::compare_distance(q[0], q[1], q[2]); },
      [](const Quintuple& q) { return k::exact::compare_distance(q[0], q[1], q[2]); });
}

TEST_CASE("wide_predicates_of_weighted_points_agree_with_rational_arithmetic") {
  Random random(96);
  const int calls = scaled_calls(60);
  for (int kind = 0; kind < weight_kinds; ++kind)
    for (int i = 0; i < calls; ++i) {
      for (const PointFamily& family : point_families()) {
        const auto q = weigh(random, family.draw(random), kind);
        CAPTURE(family.name);
        CAPTURE(kind);
        REQUIRE(w::power_test(q[0], q[1], q[2], q[3]) == k::exact::power_test(q[0], q[1], q[2], q[3]));
        REQUIRE(w::compare_power_distance(q[0].point, q[1], q[2]) ==
                k::exact::compare_power_distance(q[0].point, q[1], q[2]));
      }
      for (const PointFamily3& family : point_families3()) {
        const auto q = weigh(random, family.draw(random), kind);
        CAPTURE(family.name);
        CAPTURE(kind);
        REQUIRE(w::power_test(q[0], q[1], q[2], q[3], q[4]) ==
                k::exact::power_test(q[0], q[1], q[2], q[3], q[4]));
        REQUIRE(w::compare_power_distance(q[0].point, q[1], q[2]) ==
                k::exact::compare_power_distance(q[0].point, q[1], q[2]));
      }
    }
}

TEST_CASE("no_tie_is_taken_for_a_sign_where_errors_are_largest") {
  Random random(97);
  const int calls = scaled_calls(40'000);
  for (int i = 0; i < calls; ++i) {
    const int spread = integer(random, 0, 2);
    const auto any = [&] { return almost_a_power_of_two(random, spread); };
    const double x = any(), y = any(), z = any(), right = any(), top = any(), back = any();
    const double scale = std::ldexp(1, integer(random, -1, 1));
    REQUIRE(w::orient2d({x, y}, {scale * x, scale * y}, {-x, -y}).sign == Sign::zero);
    REQUIRE(w::incircle({x, y}, {right, top}, {right, y}, {x, top}).sign == Sign::zero);
    REQUIRE(w::orient3d({x, y, z}, {scale * x, scale * y, back}, {-x, -y, top}, {x, y, right}).sign ==
            Sign::zero);
    REQUIRE(w::insphere({x, y, z}, {right, top, z}, {right, y, back}, {x, top, back}, {x, y, back}).sign ==
            Sign::zero);
  }
}
