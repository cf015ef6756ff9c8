// SPDX-License-Identifier: MIT
#include "leonhard/kernel/constructions.hpp"

#include <doctest/doctest.h>

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using namespace leonhard;
using namespace leonhard::testing;

namespace {

using Vector = std::array<mpq_class, 3>;

Vector exact(const Point2& p) { return {p.x, p.y, 0}; }
Vector exact(const Point3& p) { return {p.x, p.y, p.z}; }
double size(const Point2& p) { return std::abs(p.x) + std::abs(p.y); }
double size(const Point3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The point x with rows[i] . x = right[i], by Cramer's rule.
Vector intersection(const std::array<Vector, 3>& rows, const Vector& right) {
  const Vector a = cross(rows[1], rows[2]), b = cross(rows[2], rows[0]), c = cross(rows[0], rows[1]);
  const mpq_class determinant = dot(rows[0], a);
  Vector x;
  for (std::size_t i = 0; i < 3; ++i)
    x[i] = (right[0] * a[i] + right[1] * b[i] + right[2] * c[i]) / determinant;
  return x;
}

Vector exact_centre(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const mpq_class aa = dot(a, a);
  return intersection({minus(b, a), minus(c, a), minus(d, a)},
                      {(dot(b, b) - aa) / 2, (dot(c, c) - aa) / 2, (dot(d, d) - aa) / 2});
}
Vector exact_centre(const Vector& a, const Vector& b, const Vector& c) {
  const Vector normal = cross(minus(b, a), minus(c, a));
  const mpq_class aa = dot(a, a);
  return intersection({minus(b, a), minus(c, a), normal},
                      {(dot(b, b) - aa) / 2, (dot(c, c) - aa) / 2, dot(normal, a)});
}

/// Both errors cover the distance from the exact centre and radius, and are as small as promised.
template <class Point>
bool keeps_its_bounds(const k::RoundedBall<Point>& ball, const Vector& centre, const Vector& on_it) {
  const Vector miss = minus(exact(ball.centre), centre), spoke = minus(on_it, centre);
  const mpq_class error(ball.centre_error), r(ball.radius), r_error(ball.radius_error),
      square = dot(spoke, spoke);
  const mpq_class low = r - r_error, high = r + r_error;
  return dot(miss, miss) <= error * error && (low <= 0 || low * low <= square) && square <= high * high &&
         ball.centre_error <= 0x1p-50 * ball.radius + 0x1p-50 * size(ball.centre) + 0x1p-1072 &&
         ball.radius_error <= 0x1p-49 * ball.radius + 0x1p-1072;
}

bool exceeds_doubles(const Vector& centre, const Vector& on_it) {
  const mpq_class largest(std::numeric_limits<double>::max());
  const Vector spoke = minus(on_it, centre);
  return abs(centre[0]) > largest || abs(centre[1]) > largest || abs(centre[2]) > largest ||
         dot(spoke, spoke) > largest * largest;
}

/// Compares what `construct` returns with the exact centre, or that it throws where that exceeds the largest
/// double.
template <class Construct>
bool is_right(Construct construct, const Vector& centre, const Vector& on_it) {
  try {
    return keeps_its_bounds(construct(), centre, on_it);
  } catch (const InputError&) {
    return exceeds_doubles(centre, on_it);
  }
}

}  // namespace

TEST_CASE("circumcircles_keep_their_bounds") {
  Random random(91);
  const int calls = scaled_calls(1'000);
  for (const PointFamily& family : point_families())
    for (int i = 0; i < calls; ++i) {
      const Quadruple p = family.draw(random);
      CAPTURE(family.name);
      CAPTURE(as_source(p));
      const auto circle = [&] { return k::circumcircle(p[0], p[1], p[2]); };
      if (k::exact::orient2d(p[0], p[1], p[2]) == Sign::zero) {
        REQUIRE_THROWS_AS((void)circle(), InputError);
        continue;
      }
      const Vector a = exact(p[0]), centre = exact_centre(a, exact(p[1]), exact(p[2]));
      REQUIRE(is_right(circle, centre, a));
    }
}

TEST_CASE("circumspheres_and_circles_in_space_keep_their_bounds") {
  Random random(92);
  const int calls = scaled_calls(500);
  for (const PointFamily3& family : point_families3())
    for (int i = 0; i < calls; ++i) {
      const Quintuple p = family.draw(random);
      CAPTURE(family.name);
      CAPTURE(as_source(p));
      const Vector a = exact(p[0]), b = exact(p[1]), c = exact(p[2]), d = exact(p[3]);
      const Vector normal = cross(minus(b, a), minus(c, a));
      const auto circle = [&] { return k::circumcircle(p[0], p[1], p[2]); };
      const auto sphere = [&] { return k::circumsphere(p[0], p[1], p[2], p[3]); };
      if (dot(normal, normal) == 0)
        REQUIRE_THROWS_AS((void)circle(), InputError);
      else
        REQUIRE(is_right(circle, exact_centre(a, b, c), a));
      if (dot(normal, minus(d, a)) == 0)
        REQUIRE_THROWS_AS((void)sphere(), InputError);
      else
        REQUIRE(is_right(sphere, exact_centre(a, b, c, d), a));
    }
}

TEST_CASE("a_containment_circle_is_that_of_the_longest_edge_unless_all_angles_are_acute") {
  const k::Circle acute = k::containment_circle({0, 0}, {4, 0}, {2, 3});
  CHECK(acute.centre.x == 2);
  CHECK(std::abs(acute.centre.y - 5.0 / 6) <= acute.centre_error);
  for (const Point2 apex : {Point2{1, 1}, Point2{2, 2}, Point2{1, 0}, Point2{4, 0}}) {
    const k::Circle obtuse = k::containment_circle(apex, {0, 0}, {4, 0});
    CHECK(obtuse.centre == Point2{2, 0});
    CHECK(obtuse.radius == 2);
    CHECK(k::containment_circle({0, 0}, {4, 0}, apex).centre == obtuse.centre);
  }
  CHECK(k::containment_circle({1, 2}, {1, 2}, {1, 2}).radius == 0);
}

TEST_CASE("an_off_centre_is_the_circumcentre_or_a_point_at_its_reach") {
  const Point2 a{0, 0}, b{2, 0}, apex{1, 100};
  CHECK(k::off_centre(a, b, apex, 3).centre == Point2{1, 6});
  CHECK(k::off_centre(apex, b, a, 3).centre == Point2{1, 6});
  CHECK(k::off_centre(b, {1, -100}, a, 3).centre == Point2{1, -6});
  CHECK(k::off_centre(a, b, apex, INFINITY).centre == k::circumcircle(a, b, apex).centre);
  CHECK(k::off_centre(a, b, {0, 2}, 3).centre == Point2{1, 1});
  CHECK_THROWS_AS((void)k::off_centre(a, b, apex, 0), InputError);
  CHECK_THROWS_AS((void)k::off_centre(a, b, {5, 0}, 3), InputError);
  // The triangle over the edge has the ratio asked for.
  const double reach = k::off_centre_reach(1.4);
  const k::Circle over = k::circumcircle(Point2{0, 0}, {1, 0}, {0.5, reach});
  CHECK(over.radius == doctest::Approx(1.4).epsilon(1e-14));
  CHECK_THROWS_AS((void)k::off_centre_reach(0.4), InputError);
}

TEST_CASE("constructions_name_the_points_that_have_no_circle") {
  try {
    (void)k::circumcircle(Point2{0, 0}, {1, 1}, {2.5, 2.5});
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(error.problem() == "(0, 0), (1, 1), (2.5, 2.5) are collinear");
  }
}
