// SPDX-License-Identifier: MIT
// What made predicates elsewhere answer wrongly, each named after what broke. Two more of the kind stand beside their
// predicates: the smallest triangle (JuliaGeometry/AdaptivePredicates.jl, issue 4) in predicates_test.cpp, and a bound
// made for a longer format (spirula-studio, issue 60) in predicates3_test.cpp.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/point_families.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Sign;
using leonhard::sign_of;
using leonhard::Vec2;
using namespace leonhard::testing;

namespace {

/// A grid of side x side points, `step` apart, from `corner` on.
std::vector<Point2> fine_grid(Point2 corner, double step, int side) {
  std::vector<Point2> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) points.push_back({corner.x + i * step, corner.y + j * step});
  return points;
}

Sign rounded_orient2d(Point2 a, Point2 b, Point2 c) { return sign_of(cross(a - c, b - c)); }

Sign rounded_incircle(Point2 a, Point2 b, Point2 c, Point2 d) {
  const Vec2 u = a - d, v = b - d, w = c - d;
  return sign_of(dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v));
}

Point2 at_scale(Point2 p, int exponent) { return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; }
Point3 at_scale(const Point3& p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}

// Powers of two by which integers below 2^5 can be scaled without error.
constexpr int lowest_exponent = -1074, highest_exponent = 1018;

}  // namespace

// ---- near-degenerate grids ----

TEST_CASE("orient2d_is_right_on_the_grid_where_plain_doubles_are_wrong_5474_times") {
  // L. Kettner, K. Mehlhorn, S. Pion, S. Schirra and C. Yap, "Classroom examples of robustness problems in geometric
  // computations", Computational Geometry 40 (2008), figure 2; the count is that of stillwater-sc/universal, pull
  // request 1354.
  const Point2 b{12, 12}, c{24, 24};
  int wrong = 0, on_the_line = 0;
  for (const Point2 a : fine_grid({0.5, 0.5}, 0x1p-53, 128)) {
    const Sign truth = k::exact::orient2d(a, b, c);
    REQUIRE(k::orient2d(a, b, c) == truth);
    wrong += rounded_orient2d(a, b, c) != truth;
    on_the_line += truth == Sign::zero;
  }
  CHECK(on_the_line == 128);
  CHECK(wrong == 5474);
}

TEST_CASE("incircle_is_right_on_a_grid_of_4096_points_beside_the_circle") {
  // The same about a corner of a square, whose other corners make the circle; plain doubles are wrong 1764 times.
  const Point2 a{12.5, 0.5}, b{12.5, 12.5}, c{0.5, 12.5};
  int wrong = 0;
  for (const Point2 d : fine_grid({0.5 - 0x1p-48, 0.5 - 0x1p-48}, 0x1p-53, 64)) {
    const Sign truth = k::exact::incircle(a, b, c, d);
    REQUIRE(k::incircle(a, b, c, d) == truth);
    wrong += rounded_incircle(a, b, c, d) != truth;
  }
  CHECK(wrong == 1764);
}

TEST_CASE("orient3d_is_right_on_the_grid_carried_into_space") {
  const Point3 b{12, 12, 24}, c{24, 24, 48}, d{1, 2, 3};  // the plane through b, c, d is x + y - z = 0
  int on_the_plane = 0;
  for (const Point2 p : fine_grid({0.5, 0.5}, 0x1p-53, 64)) {
    const Point3 a{p.x, p.y, 1};
    const Sign truth = k::exact::orient3d(a, b, c, d);
    REQUIRE(k::orient3d(a, b, c, d) == truth);
    on_the_plane += truth == Sign::zero;
  }
  CHECK(on_the_plane == 1);
}

TEST_CASE("insphere_is_right_on_a_grid_beside_the_sphere") {
  const Point3 a{12.5, 0.5, 0.5}, b{12.5, 12.5, 0.5}, c{0.5, 12.5, 0.5}, d{0.5, 0.5, 12.5};
  int on_the_sphere = 0;
  for (const Point2 p : fine_grid({0.5 - 0x1p-49, 0.5 - 0x1p-49}, 0x1p-53, 32)) {
    const Point3 e{p.x, p.y, 0.5};
    const Sign truth = k::exact::insphere(a, b, c, d, e);
    REQUIRE(k::insphere(a, b, c, d, e) == truth);
    on_the_sphere += truth == Sign::zero;
  }
  CHECK(on_the_sphere == 1);
}

// ---- ranges ----

TEST_CASE("incircle_is_right_where_tiny_and_huge_coordinates_made_it_nan") {
  // georust/robust, issue 19, and golang/geo, pull request 263: infinite and vanishing products meet.
  Random random(19);
  struct Mixture {
    double tiny, huge;
  };
  for (const Mixture& mixture : {Mixture{1e-13, 1e23}, Mixture{1e-135, 1e235}, Mixture{1e-265, 1e236}}) {
    CAPTURE(mixture.tiny);
    const auto either = [&] {
      return uniform(random) * (integer(random, 0, 1) == 0 ? mixture.tiny : mixture.huge);
    };
    for (int i = 0; i < 2'000; ++i) {
      const Quadruple q = each_coordinate(either);
      CAPTURE(as_source(q));
      REQUIRE(k::incircle(q[0], q[1], q[2], q[3]) == k::exact::incircle(q[0], q[1], q[2], q[3]));
      REQUIRE(k::orient2d(q[0], q[1], q[2]) == k::exact::orient2d(q[0], q[1], q[2]));
    }
    for (int i = 0; i < 400; ++i) {
      const Quintuple q = each_coordinate3(either);
      CAPTURE(as_source(q));
      REQUIRE(k::insphere(q[0], q[1], q[2], q[3], q[4]) == k::exact::insphere(q[0], q[1], q[2], q[3], q[4]));
      REQUIRE(k::orient3d(q[0], q[1], q[2], q[3]) == k::exact::orient3d(q[0], q[1], q[2], q[3]));
    }
  }
}

TEST_CASE("orient2d_has_no_range_limits_at_two_to_the_511") {
  // Beyond 2^-512 and 2^512 products vanish or become infinite, and double-double arithmetic says "collinear":
  // locationtech/jts, pull request 1197.
  const Point2 a{0, 0}, b{3, 5}, left{17, 29}, on{18, 30}, right{19, 31};
  for (int e = lowest_exponent; e <= highest_exponent; ++e) {
    CAPTURE(e);
    REQUIRE(k::orient2d(at_scale(a, e), at_scale(b, e), at_scale(left, e)) == Sign::positive);
    REQUIRE(k::orient2d(at_scale(a, e), at_scale(b, e), at_scale(on, e)) == Sign::zero);
    REQUIRE(k::orient2d(at_scale(a, e), at_scale(b, e), at_scale(right, e)) == Sign::negative);
  }
}

TEST_CASE("incircle_has_no_range_limits_at_two_to_the_250") {
  const Point2 a{25, 0}, b{0, 25}, c{-25, 0}, inside{-7, -23}, on{-7, -24}, outside{-7, -25};
  for (int e = lowest_exponent; e <= highest_exponent; ++e) {
    CAPTURE(e);
    REQUIRE(k::incircle(at_scale(a, e), at_scale(b, e), at_scale(c, e), at_scale(inside, e)) ==
            Sign::positive);
    REQUIRE(k::incircle(at_scale(a, e), at_scale(b, e), at_scale(c, e), at_scale(on, e)) == Sign::zero);
    REQUIRE(k::incircle(at_scale(a, e), at_scale(b, e), at_scale(c, e), at_scale(outside, e)) ==
            Sign::negative);
  }
}

TEST_CASE("orient3d_has_no_range_limits") {
  const Point3 a{0, 0, 0}, b{3, 5, 1}, c{2, 7, 4}, above{1, -2, -2}, on{1, -2, -3}, below{1, -2, -4};
  for (int e = lowest_exponent; e <= highest_exponent; ++e) {
    CAPTURE(e);
    const Point3 p = at_scale(a, e), q = at_scale(b, e), r = at_scale(c, e);
    REQUIRE(k::orient3d(p, q, r, at_scale(above, e)) == Sign::positive);
    REQUIRE(k::orient3d(p, q, r, at_scale(on, e)) == Sign::zero);
    REQUIRE(k::orient3d(p, q, r, at_scale(below, e)) == Sign::negative);
  }
}

TEST_CASE("insphere_has_no_range_limits_at_two_to_the_200") {
  const Point3 a{9, 0, 0}, b{0, 9, 0}, c{-9, 0, 0}, d{0, 0, 9}, inside{-4, -4, -6}, on{-4, -4, -7},
      outside{-4, -4, -8};
  REQUIRE(k::orient3d(a, b, c, d) == Sign::positive);
  for (int e = lowest_exponent; e <= highest_exponent; ++e) {
    CAPTURE(e);
    const Point3 p = at_scale(a, e), q = at_scale(b, e), r = at_scale(c, e), s = at_scale(d, e);
    REQUIRE(k::insphere(p, q, r, s, at_scale(inside, e)) == Sign::positive);
    REQUIRE(k::insphere(p, q, r, s, at_scale(on, e)) == Sign::zero);
    REQUIRE(k::insphere(p, q, r, s, at_scale(outside, e)) == Sign::negative);
  }
}
