// SPDX-License-Identifier: MIT
#include "leonhard/kernel/implicit_point3.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/exact_implicit.hpp"
#include "tests/kernel/implicit_points.hpp"

namespace k = leonhard::kernel;
using k::LinePlaneCrossing;
using k::Stage;
using k::ThreePlaneCrossing;
using leonhard::Point3;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

using TestPoints = std::array<TestPoint3, 5>;

/// Calls check(points) with points of all families and of every mixture of kinds.
template <class Check>
void for_all_families(int calls_a_family, Check check) {
  Random random(20241102);
  calls_a_family = scaled_calls(calls_a_family);
  for (const PointFamily3& family : point_families3()) {
    CAPTURE(family.name);
    for (int i = 0; i < calls_a_family; ++i) {
      std::vector<Point3> pool;
      for (int draws = integer(random, 1, 3); draws > 0; --draws)
        for (const Point3& p : family.draw(random)) pool.push_back(p);
      TestPoints points;
      for (TestPoint3& p : points) p = draw_point3(random, pool);
      check(points);
    }
  }
}

}  // namespace

TEST_CASE("predicates_of_plane_crossings_agree_with_rational_arithmetic_at_every_stage") {
  for_all_families(60, [](const TestPoints& points) {
    const auto& [a, b, c, d, e] = points;
    const Sign turn = k::exact::orient3d(a.truth, b.truth, c.truth, d.truth);
    const Sign inside = k::exact::insphere(a.truth, b.truth, c.truth, d.truth, e.truth);
    const Sign order = k::exact::compare_xyz(a.truth, b.truth);
    CAPTURE(as_source(points));
    REQUIRE(k::orient3d(a.ref(), b.ref(), c.ref(), d.ref()) == turn);
    REQUIRE(k::insphere(a.ref(), b.ref(), c.ref(), d.ref(), e.ref()) == inside);
    REQUIRE(k::compare_xyz(a.ref(), b.ref()) == order);
    for (const Stage first : all_stages) {
      CAPTURE(static_cast<int>(first));
      REQUIRE(k::orient3d_staged(a.ref(), b.ref(), c.ref(), d.ref(), first).sign == turn);
      REQUIRE(k::insphere_staged(a.ref(), b.ref(), c.ref(), d.ref(), e.ref(), first).sign == inside);
      REQUIRE(k::compare_xyz_staged(a.ref(), b.ref(), first).sign == order);
    }
  });
}

TEST_CASE("a_plane_crossing_is_rounded_to_the_nearest_doubles_and_lies_in_its_balls") {
  for_all_families(60, [](const TestPoints& points) {
    CAPTURE(as_source(points));
    for (const TestPoint3& p : points) {
      const k::RoundedPoint3 rounded = k::rounded(p.ref());
      REQUIRE(is_rounded_well(rounded.point.x, rounded.error, p.truth.x));
      REQUIRE(is_rounded_well(rounded.point.y, rounded.error, p.truth.y));
      REQUIRE(is_rounded_well(rounded.point.z, rounded.error, p.truth.z));
      const auto balls = p.ref().coordinates();
      REQUIRE(contains(balls[0], p.truth.x));
      REQUIRE(contains(balls[1], p.truth.y));
      REQUIRE(contains(balls[2], p.truth.z));
    }
  });
}

TEST_CASE("predicates_of_plane_crossings_have_the_documented_signs") {
  const Point3 o{0, 0, 0}, x{3, 0, 0}, y{0, 3, 0}, z{0, 0, 3};
  const LinePlaneCrossing on_line({1, 1, 0}, {1, 1, 7}, {0, 0, 1}, {5, 0, 1}, {0, 5, 1});  // (1, 1, 1)
  const ThreePlaneCrossing on_planes({{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}}}, {{{0, 1, 0}, {1, 1, 0}, {0, 1, 1}}},
                                     {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}});  // the same
  CHECK(k::compare_xyz(on_line, on_planes) == Sign::zero);
  CHECK(k::orient3d(o, x, y, on_line) == Sign::positive);
  CHECK(k::orient3d(o, y, x, on_planes) == Sign::negative);
  CHECK(k::orient3d(x, y, z, on_planes) == Sign::zero);
  CHECK(k::orient3d(on_line, on_planes, y, z) == Sign::zero);
  CHECK(k::insphere(o, x, y, z, on_line) == Sign::positive);
  CHECK(k::insphere(o, x, y, on_planes, Point3{9, 9, 9}) == Sign::negative);
  CHECK(k::insphere(o, Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}, on_planes) == Sign::zero);
  CHECK(k::compare_xyz(on_line, Point3{1, 1, 2}) == Sign::negative);
  CHECK(k::compare_xyz(Point3{1, 2, 0}, on_planes) == Sign::positive);
  CHECK(k::rounded(on_planes).point == Point3{1, 1, 1});
  CHECK(k::rounded(x).point == x);
  CHECK(k::rounded(x).error == 0);
}

TEST_CASE("points_of_space_that_are_explicit_keep_the_overloads_of_explicit_points") {
  CHECK(k::orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == Sign::positive);
  const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  using k::PointRef3;
  CHECK(k::orient3d(PointRef3(o), PointRef3(x), PointRef3(y), PointRef3(z)) == Sign::positive);
  CHECK(k::insphere(PointRef3(o), PointRef3(x), PointRef3(y), PointRef3(z), PointRef3(o)) == Sign::zero);
}

TEST_CASE("four_planes_through_one_point_cross_there") {
  // Planes x + y + z = 1, x = y, y = z, whose point (1/3, 1/3, 1/3) has no doubles, and a line on which it lies.
  const k::PlanePoints slant{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, xy{{{0, 0, 0}, {1, 1, 0}, {0, 0, 1}}},
      yz{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}}, xz{{{0, 0, 0}, {0, 1, 0}, {1, 0, 1}}};
  const ThreePlaneCrossing third(slant, xy, yz), again(xz, slant, xy);
  const LinePlaneCrossing on_diagonal({0, 0, 0}, {7, 7, 7}, slant[0], slant[1], slant[2]);
  CHECK(k::compare_xyz(third, again) == Sign::zero);
  CHECK(k::compare_xyz(third, on_diagonal) == Sign::zero);
  CHECK(k::orient3d(xz[0], xz[1], xz[2], third) == Sign::zero);
  CHECK(k::orient3d(xz[0], xz[1], Point3{1, 0, std::nextafter(1, 2)}, third) != Sign::zero);
  CHECK(k::insphere(third, again, xz[1], xz[2], slant[0]) == Sign::zero);
}

TEST_CASE("predicates_of_plane_crossings_follow_the_sign_of_every_permutation") {
  for_all_families(4, [](const TestPoints& q) {
    CAPTURE(as_source(q));
    const Sign turn = k::orient3d(q[0].ref(), q[1].ref(), q[2].ref(), q[3].ref());
    std::array<std::size_t, 4> p{0, 1, 2, 3};
    do
      REQUIRE(k::orient3d(q[p[0]].ref(), q[p[1]].ref(), q[p[2]].ref(), q[p[3]].ref()) ==
              permutation_sign(p) * turn);
    while (std::ranges::next_permutation(p).found);
    const Sign inside = k::insphere(q[0].ref(), q[1].ref(), q[2].ref(), q[3].ref(), q[4].ref());
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = i + 1; j < 5; ++j) {
        std::array<std::size_t, 5> r{0, 1, 2, 3, 4};
        std::swap(r[i], r[j]);
        REQUIRE(k::insphere(q[r[0]].ref(), q[r[1]].ref(), q[r[2]].ref(), q[r[3]].ref(), q[r[4]].ref()) ==
                -inside);
      }
  });
}

TEST_CASE("plane_crossings_are_refused_where_there_is_none") {
  for_all_families(60, [](const TestPoints& points) {
    std::vector<Point3> q;
    for (const TestPoint3& p : points)
      for (const Point3& r : p.defining) q.push_back(r);
    q.resize(9);
    CAPTURE(as_source(points));
    if (!crossing({q[0], q[1], q[2], q[3], q[4]}))
      REQUIRE_THROWS_AS(LinePlaneCrossing(q[0], q[1], q[2], q[3], q[4]), leonhard::InputError);
    if (!crossing(q))
      REQUIRE_THROWS_AS(ThreePlaneCrossing({q[0], q[1], q[2]}, {q[3], q[4], q[5]}, {q[6], q[7], q[8]}),
                        leonhard::InputError);
  });
  const auto problem = [](const Point3& p, const Point3& q) -> std::string {
    try {
      (void)LinePlaneCrossing(p, q, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    } catch (const leonhard::InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(problem({0, 0, 1}, {5, 5, 1 + 0x1p-52}) == "");
  CHECK(problem({0, 0, smallest}, {largest, 0, 0}) == "");
  CHECK(problem({0, 0, 1}, {0.5, 7, 1}) ==
        "LinePlaneCrossing: line and plane are parallel, or their points do not span them: (0, 0, 1), (0.5, "
        "7, 1), "
        "(0, 0, 0), (1, 0, 0), (0, 1, 0); make crossings of segments whose ends orient3d says to be on both "
        "sides of "
        "the plane");
}
