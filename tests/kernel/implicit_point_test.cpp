// SPDX-License-Identifier: MIT
#include "leonhard/kernel/implicit_point.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/stages/exact_implicit.hpp"
#include "tests/kernel/implicit_points.hpp"

namespace k = leonhard::kernel;
using k::LineCrossing;
using k::Stage;
using leonhard::Point2;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

using TestPoints = std::array<TestPoint2, 4>;

/// Calls check(points) with points of all families and of every mixture of kinds.
template <class Check>
void for_all_families(int calls_a_family, Check check) {
  Random random(20241101);
  calls_a_family = scaled_calls(calls_a_family);
  for (const PointFamily& family : point_families()) {
    CAPTURE(family.name);
    for (int i = 0; i < calls_a_family; ++i) {
      std::vector<Point2> pool;
      for (int draws = integer(random, 1, 3); draws > 0; --draws)
        for (const Point2& p : family.draw(random)) pool.push_back(p);
      TestPoints points;
      for (TestPoint2& p : points) p = draw_point2(random, pool);
      check(points);
    }
  }
}

}  // namespace

TEST_CASE("predicates_of_line_crossings_agree_with_rational_arithmetic_at_every_stage") {
  for_all_families(300, [](const TestPoints& points) {
    const auto& [a, b, c, d] = points;
    const Sign turn = k::exact::orient2d(a.truth, b.truth, c.truth);
    const Sign inside = k::exact::incircle(a.truth, b.truth, c.truth, d.truth);
    const Sign order = k::exact::compare_xy(a.truth, b.truth);
    CAPTURE(as_source(points));
    REQUIRE(k::orient2d(a.ref(), b.ref(), c.ref()) == turn);
    REQUIRE(k::incircle(a.ref(), b.ref(), c.ref(), d.ref()) == inside);
    REQUIRE(k::compare_xy(a.ref(), b.ref()) == order);
    for (const Stage first : all_stages) {
      CAPTURE(static_cast<int>(first));
      REQUIRE(k::orient2d_staged(a.ref(), b.ref(), c.ref(), first).sign == turn);
      REQUIRE(k::incircle_staged(a.ref(), b.ref(), c.ref(), d.ref(), first).sign == inside);
      REQUIRE(k::compare_xy_staged(a.ref(), b.ref(), first).sign == order);
    }
  });
}

TEST_CASE("a_line_crossing_is_rounded_to_the_nearest_doubles") {
  for_all_families(600, [](const TestPoints& points) {
    const TestPoint2& p = points[0];
    CAPTURE(as_source(points));
    const k::RoundedPoint2 rounded = k::rounded(p.ref());
    REQUIRE(is_rounded_well(rounded.point.x, rounded.error, p.truth.x));
    REQUIRE(is_rounded_well(rounded.point.y, rounded.error, p.truth.y));
    const double size = std::max(std::abs(rounded.point.x), std::abs(rounded.point.y));
    if (std::isinf(rounded.error))
      REQUIRE(size == largest);
    else
      REQUIRE(rounded.error <= std::max(0x1p-53 * size, smallest));
  });
}

TEST_CASE("the_coordinates_of_a_line_crossing_lie_in_its_balls") {
  for_all_families(300, [](const TestPoints& points) {
    const TestPoint2& p = points[0];
    CAPTURE(as_source(points));
    const auto balls = p.ref().coordinates();
    REQUIRE(contains(balls[0], p.truth.x));
    REQUIRE(contains(balls[1], p.truth.y));
  });
}

TEST_CASE("predicates_of_line_crossings_have_the_documented_signs") {
  const LineCrossing middle({0, 0}, {2, 2}, {0, 2}, {2, 0});  // (1, 1)
  const Point2 o{0, 0}, x{3, 0}, y{0, 3};
  CHECK(k::orient2d(o, x, middle) == Sign::positive);
  CHECK(k::orient2d(x, o, middle) == Sign::negative);
  CHECK(k::orient2d(Point2{0, 2}, Point2{2, 0}, middle) == Sign::zero);
  CHECK(k::incircle(o, x, y, middle) == Sign::positive);
  CHECK(k::incircle(o, middle, y, x) == Sign::negative);
  CHECK(k::incircle(o, Point2{1, 0}, middle, Point2{0, 1}) == Sign::zero);
  CHECK(k::compare_xy(middle, Point2{1, 1}) == Sign::zero);
  CHECK(k::compare_xy(middle, Point2{1, 2}) == Sign::negative);
  CHECK(k::compare_xy(Point2{1.5, 0}, middle) == Sign::positive);
  CHECK(k::rounded(middle).point == Point2{1, 1});
  CHECK(k::rounded(x).point == x);
  CHECK(k::rounded(x).error == 0);
}

TEST_CASE("points_that_are_explicit_keep_the_overloads_of_explicit_points") {
  const Point2 a{0, 0}, b{1, 0}, c{0, 1};
  CHECK(k::orient2d({0, 0}, {1, 0}, {0, 1}) == Sign::positive);
  CHECK(k::orient2d(k::PointRef2(a), k::PointRef2(b), k::PointRef2(c)) == Sign::positive);
  CHECK(k::incircle(k::PointRef2(a), k::PointRef2(b), k::PointRef2(c), k::PointRef2(a)) == Sign::zero);
}

TEST_CASE("three_lines_through_one_point_cross_there") {
  // No coordinate of (1/3, 1/3) is a double.
  const Point2 o{0, 0};
  const LineCrossing third(o, {1, 1}, {1, 0}, {0, 0.5}), again(o, {7, 7}, {0.5, 0}, {0, 1});
  CHECK(k::compare_xy(third, again) == Sign::zero);
  CHECK(k::orient2d(third, o, again) == Sign::zero);
  CHECK(k::orient2d(third, Point2{0.5, 0}, Point2{0, 1}) == Sign::zero);
  CHECK(k::orient2d(third, Point2{0.5, 0}, Point2{0, std::nextafter(1, 2)}) == Sign::positive);
  CHECK(k::orient2d(third, Point2{0.5, 0}, Point2{0, std::nextafter(1, 0)}) == Sign::negative);
  const LineCrossing beside(o, {std::nextafter(1, 2), 1}, {1, 0}, {0, 0.5});
  CHECK(k::compare_xy(third, beside) == Sign::negative);
}

TEST_CASE("predicates_of_line_crossings_follow_the_sign_of_every_permutation") {
  for_all_families(20, [](const TestPoints& q) {
    CAPTURE(as_source(q));
    const Sign turn = k::orient2d(q[0].ref(), q[1].ref(), q[2].ref());
    std::array<std::size_t, 3> p{0, 1, 2};
    do REQUIRE(k::orient2d(q[p[0]].ref(), q[p[1]].ref(), q[p[2]].ref()) == permutation_sign(p) * turn);
    while (std::ranges::next_permutation(p).found);
    const Sign inside = k::incircle(q[0].ref(), q[1].ref(), q[2].ref(), q[3].ref());
    std::array<std::size_t, 4> r{0, 1, 2, 3};
    do
      REQUIRE(k::incircle(q[r[0]].ref(), q[r[1]].ref(), q[r[2]].ref(), q[r[3]].ref()) ==
              permutation_sign(r) * inside);
    while (std::ranges::next_permutation(r).found);
  });
}

TEST_CASE("balls_decide_all_predicates_of_uniform_line_crossings") {
  Random random(74);
  std::array<int, 6> count{};  // by stage
  for (int i = 0; i < 2'000; ++i) {
    std::array<TestPoint2, 4> points;
    for (TestPoint2& p : points)
      while (!p.crossing) p = crossing(each_coordinate([&] { return uniform(random); })).value_or(p);
    const auto& [a, b, c, d] = points;
    ++count[static_cast<std::size_t>(k::orient2d_staged(a.ref(), b.ref(), c.ref()).stage)];
    ++count[static_cast<std::size_t>(k::incircle_staged(a.ref(), b.ref(), c.ref(), d.ref()).stage)];
  }
  CHECK(count[0] > 3'990);
  CHECK(count[0] + count[static_cast<std::size_t>(Stage::double_double)] == 4'000);
}

TEST_CASE("lines_without_a_crossing_are_refused") {
  const auto problem = [](const Point2& a, const Point2& b, const Point2& c, const Point2& d) -> std::string {
    try {
      (void)LineCrossing(a, b, c, d);
    } catch (const leonhard::InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(problem({0, 0}, {1, 0.1}, {0, 1}, {10, 2}) == "");  // 0.1 is not a tenth
  CHECK(problem({0, 0}, {1, 0.125}, {0, 1}, {8, 2}) ==
        "LineCrossing: lines are parallel, or the points of one are equal: (0, 0), (1, 0.125), (0, 1), (8, "
        "2); make "
        "crossings of segments that orient2d says to cross");
  CHECK(problem({1, 1}, {1, 1}, {0, 0}, {2, 3}) != "");
  CHECK(problem({0, 0}, {smallest, smallest}, {0, 1}, {largest, largest}) == "");
  CHECK(problem({0, 0}, {smallest, smallest}, {0, 0}, {largest, largest}) != "");
  CHECK(
      problem({0, 0}, {0, NAN}, {0, 1}, {1, 0}).starts_with("LineCrossing: a defining point is not finite"));
}

TEST_CASE("coordinates_beyond_the_largest_double_become_that") {
  const double close = std::nextafter(1, 2);
  const LineCrossing far({0, 0}, {1e300, 1e300}, {0, 1e300}, {1e300, 2e300 * close});
  const k::RoundedPoint2 rounded = k::rounded(far);
  CHECK(rounded.point == Point2{-largest, -largest});
  CHECK(std::isinf(rounded.error));
  CHECK(k::orient2d(Point2{0, 1}, far, Point2{0, 0}) == Sign::positive);
}

TEST_CASE("a_crossing_keeps_bits_that_are_lost_beside_its_largest_coordinate") {
  const LineCrossing low({0, smallest}, {1, smallest}, {1, 0}, {1, 0x1p600});
  CHECK(k::rounded(low).point == Point2{1, smallest});
  CHECK(k::orient2d(Point2{0, 0}, Point2{1, 0}, low) == Sign::positive);
}
