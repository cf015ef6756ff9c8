// SPDX-License-Identifier: MIT
#include "leonhard/kernel/predicates3.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using leonhard::Point3;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

/// Checks a predicate and its exact part on all 24 families.
template <class Predicate, class Exact, class Oracle>
void check_against_oracle(int calls_a_family, Predicate predicate, Exact exact_part, Oracle oracle) {
  Random random(20240301);
  calls_a_family = scaled_calls(calls_a_family);
  for (const PointFamily3& family : point_families3()) {
    CAPTURE(family.name);
    for (int i = 0; i < calls_a_family; ++i) {
      const Quintuple q = family.draw(random);
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

/// A regular tetrahedron, right-handed, about the origin; all coordinates are `size` or its negative.
std::array<Point3, 4> regular_tetrahedron(double size) {
  return {{{size, size, size}, {-size, size, -size}, {size, -size, -size}, {-size, -size, size}}};
}

}  // namespace

TEST_CASE("orient3d_agrees_with_rational_arithmetic") {
  check_against_oracle(
      15'000, [](const Quintuple& q) { return k::orient3d(q[0], q[1], q[2], q[3]); },
      [](const Quintuple& q) { return k::orient3d_exact(q[0], q[1], q[2], q[3]); },
      [](const Quintuple& q) { return k::exact::orient3d(q[0], q[1], q[2], q[3]); });
}

TEST_CASE("insphere_agrees_with_rational_arithmetic") {
  check_against_oracle(
      12'000, [](const Quintuple& q) { return k::insphere(q[0], q[1], q[2], q[3], q[4]); },
      [](const Quintuple& q) { return k::insphere_exact(q[0], q[1], q[2], q[3], q[4]); },
      [](const Quintuple& q) { return k::exact::insphere(q[0], q[1], q[2], q[3], q[4]); });
}

TEST_CASE("in_diametral_sphere_agrees_with_rational_arithmetic") {
  check_against_oracle(
      15'000, [](const Quintuple& q) { return k::in_diametral_sphere(q[0], q[1], q[2]); },
      [](const Quintuple& q) { return k::in_diametral_sphere_exact(q[0], q[1], q[2]); },
      [](const Quintuple& q) { return k::exact::in_diametral_sphere(q[0], q[1], q[2]); });
}

TEST_CASE("compare_distance_in_space_agrees_with_rational_arithmetic") {
  check_against_oracle(
      15'000, [](const Quintuple& q) { return k::compare_distance(q[0], q[1], q[2]); },
      [](const Quintuple& q) { return k::compare_distance_exact(q[0], q[1], q[2]); },
      [](const Quintuple& q) { return k::exact::compare_distance(q[0], q[1], q[2]); });
}

TEST_CASE("predicates_of_space_have_the_documented_signs") {
  const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(k::orient3d(o, x, y, z) == Sign::positive);
  CHECK(k::orient3d(o, y, x, z) == Sign::negative);
  CHECK(k::orient3d(o, x, y, {0.3, 0.4, 0}) == Sign::zero);
  CHECK(k::insphere(o, x, y, z, {0.5, 0.5, 0.5}) == Sign::positive);
  CHECK(k::insphere(o, x, y, z, {1, 1, 1}) == Sign::zero);
  CHECK(k::insphere(o, x, y, z, {1, 1, 1.5}) == Sign::negative);
  CHECK(k::insphere(o, y, x, z, {1, 1, 1.5}) == Sign::positive);
  CHECK(k::in_diametral_sphere({0.5, 0.1, 0.1}, o, x) == Sign::positive);
  CHECK(k::in_diametral_sphere({0.5, 0, 0.5}, o, x) == Sign::zero);
  CHECK(k::in_diametral_sphere({0.5, 0.4, 0.4}, o, x) == Sign::negative);
  CHECK(k::in_diametral_sphere(o, o, x) == Sign::zero);
  CHECK(k::compare_distance(o, {2, 0, 0}, {0, 1, 0}) == Sign::positive);
  CHECK(k::compare_distance(o, {2, 3, 6}, {7, 0, 0}) == Sign::zero);
}

TEST_CASE("compare_xyz_is_lexicographic") {
  CHECK(k::compare_xyz({0, 5, 5}, {1, 0, 0}) == Sign::negative);
  CHECK(k::compare_xyz({1, 5, 0}, {1, 0, 9}) == Sign::positive);
  CHECK(k::compare_xyz({1, 2, smallest}, {1, 2, 0}) == Sign::positive);
  CHECK(k::compare_xyz({0, -0.0, 0}, {-0.0, 0, -0.0}) == Sign::zero);
}

TEST_CASE("the_sphere_of_a_regular_tetrahedron_is_seen_at_every_scale") {
  for (const double size : {1.0, 3.0, 0.1, 1e-200, 1e200, 4 * smallest, largest}) {
    CAPTURE(size);
    const auto [a, b, c, d] = regular_tetrahedron(size);
    REQUIRE(k::orient3d(a, b, c, d) == Sign::positive);
    CHECK(k::insphere(a, b, c, d, {0, 0, 0}) == Sign::positive);
    // The other four corners of the cube lie on the sphere, and steps along an edge of it in and out.
    const double inner = std::nextafter(size, 0.0);
    CHECK(k::insphere(a, b, c, d, {-size, -size, -size}) == Sign::zero);
    CHECK(k::insphere(a, b, c, d, {-size, inner, size}) == Sign::positive);
    if (size < largest)
      CHECK(k::insphere(a, b, c, d, {-size, -size, -std::nextafter(size, largest)}) == Sign::negative);
  }
}

TEST_CASE("orient3d_sees_the_smallest_tetrahedron_there_is") {
  const Point3 o{0, 0, 0}, x{smallest, 0, 0}, y{0, smallest, 0}, z{0, 0, smallest};
  CHECK(k::orient3d(o, x, y, z) == Sign::positive);
  CHECK(k::orient3d(o, y, x, z) == Sign::negative);
  CHECK(k::orient3d(o, x, y, {smallest, smallest, 0}) == Sign::zero);
}

TEST_CASE("predicates_of_space_survive_differences_that_overflow") {
  const Point3 low{-largest, -largest, -largest}, x{largest, -largest, -largest},
      y{-largest, largest, -largest}, z{-largest, -largest, largest}, high{largest, largest, largest};
  CHECK(k::orient3d(low, x, y, z) == Sign::positive);
  CHECK(k::orient3d(low, {0, 0, 0}, high, z) == Sign::zero);
  CHECK(k::orient3d(low, {smallest, 0, 0}, high, z) == Sign::positive);
  CHECK(k::insphere(low, x, y, z, high) == Sign::zero);
  CHECK(k::insphere(low, x, y, z, {0, smallest, 0}) == Sign::positive);
  CHECK(k::in_diametral_sphere(x, low, high) == Sign::zero);
  CHECK(k::in_diametral_sphere({largest, largest, 0}, low, high) == Sign::positive);
  CHECK(k::compare_distance({0, 0, 0}, low, high) == Sign::zero);
  CHECK(k::compare_distance({0, 0, smallest}, low, high) == Sign::positive);
}

TEST_CASE("orient3d_is_right_where_a_bound_made_for_a_longer_format_is_not") {
  // spirula-studio, issue 60: plain double arithmetic finds -16 for the rows' determinant, which is +1.
  const Point3 a{36569, 5957284, 600211}, b{-10110, 2276334, 232673}, c{39676, 6450463, 649889}, o{0, 0, 0};
  CHECK(k::orient3d(o, a, b, c) == Sign::positive);
  CHECK(k::orient3d(a, b, c, o) == Sign::negative);
  CHECK_FALSE(k::orient3d_filter(o, a, b, c).is_certain());
}

TEST_CASE("predicates_of_space_keep_products_that_underflow_or_overflow") {
  // What makes predicates without scaling answer zero or NaN: products below 2^-1074, factors of 1e-13 beside 1e23.
  const double tiny = 0x1p-400, huge = 0x1p400;
  CHECK(k::orient3d({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}) == Sign::positive);
  CHECK(k::orient3d({0, 0, 0}, {huge, 0, 0}, {0, huge, 0}, {0, 0, huge}) == Sign::positive);
  CHECK(k::orient3d({0, 0, 0}, {huge, 0, 0}, {0, tiny, 0}, {0, 0, smallest}) == Sign::positive);
  const Point3 a{1e-13, 2e-13, 3e23}, b{1e23, -1e-13, 1e-13}, c{-2e-13, 1e23, 1e-13}, d{1e-13, 1e-13, -1e23};
  CHECK(k::insphere(a, b, c, d, {1e-13, 1e-13, 1e-13}) == k::orient3d(a, b, c, d));
}

TEST_CASE("orient3d_follows_the_sign_of_every_permutation") {
  Random random(71);
  const int calls = scaled_calls(500);
  for (const PointFamily3& family : point_families3())
    for (int i = 0; i < calls; ++i) {
      const Quintuple q = family.draw(random);
      const Sign s = k::orient3d(q[0], q[1], q[2], q[3]);
      CAPTURE(as_source(q));
      std::array<std::size_t, 4> p{0, 1, 2, 3};
      do REQUIRE(k::orient3d(q[p[0]], q[p[1]], q[p[2]], q[p[3]]) == permutation_sign(p) * s);
      while (std::ranges::next_permutation(p).found);
    }
}

TEST_CASE("insphere_follows_the_sign_of_every_permutation") {
  Random random(72);
  const int calls = scaled_calls(50);
  for (const PointFamily3& family : point_families3())
    for (int i = 0; i < calls; ++i) {
      const Quintuple q = family.draw(random);
      const Sign s = k::insphere(q[0], q[1], q[2], q[3], q[4]);
      CAPTURE(as_source(q));
      std::array<std::size_t, 5> p{0, 1, 2, 3, 4};
      do REQUIRE(k::insphere(q[p[0]], q[p[1]], q[p[2]], q[p[3]], q[p[4]]) == permutation_sign(p) * s);
      while (std::ranges::next_permutation(p).found);
    }
}

TEST_CASE("the_filters_of_space_decide_nearly_all_uniform_points") {
  Random random(73);
  int undecided = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto [a, b, c, d, e] = each_coordinate3([&random] { return uniform(random); });
    undecided += !k::orient3d_filter(a, b, c, d).is_certain();
    undecided += !k::insphere_filter(a, b, c, d, e).is_certain();
    undecided += !k::in_diametral_sphere_filter(a, b, c).is_certain();
    undecided += !k::compare_distance_filter(a, b, c).is_certain();
  }
  CHECK(undecided == 0);
}

TEST_CASE("angles_of_space_are_told_apart_by_one_bit") {
  const double above = std::nextafter(1.0, 2.0), below = std::nextafter(1.0, 0.0);
  CHECK(k::angle({1, 1, 0}, {0, 0, 0}, {-1, 1, 5}) == Sign::zero);
  CHECK(k::angle({1, 1, 0}, {0, 0, 0}, {-1, above, 5}) == Sign::positive);
  CHECK(k::angle({1, 1, 0}, {0, 0, 0}, {-1, below, 5}) == Sign::negative);
}
