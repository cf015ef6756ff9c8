// SPDX-License-Identifier: MIT
#include "leonhard/kernel/arithmetic/nearest_double.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using namespace leonhard::testing;

TEST_CASE("nearest_double_rounds_ties_to_even") {
  const mpz_class one = mpz_class(1) << 53;
  CHECK(k::nearest_double(one + 1, 1, 0) == 0x1p53);
  CHECK(k::nearest_double(one + 3, 1, 0) == 0x1p53 + 4);
  CHECK(k::nearest_double(-one - 3, 1, -60) == -(0x1p53 + 4) * 0x1p-60);
  CHECK(k::nearest_double(2 * one + 1, 2, 0) == 0x1p53);
  CHECK(k::nearest_double(2 * (one + 1) + 1, -2, 0) == -(0x1p53 + 2));
  CHECK(k::nearest_double(0, 5, 3) == 0);
  CHECK(k::nearest_double(1, 3, 0) == 1.0 / 3);
  CHECK(k::nearest_double(1, -10, 0) == -0.1);
}

TEST_CASE("nearest_double_rounds_once_at_the_ends_of_the_range") {
  constexpr double largest = std::numeric_limits<double>::max();
  CHECK(k::nearest_double(1, 1, -1074) == 0x1p-1074);
  CHECK(k::nearest_double(1, 1, -1075) == 0);
  CHECK(k::nearest_double(1, 3, -1073) == 0x1p-1074);
  CHECK(k::nearest_double(3, 1, -1075) == 0x1p-1073);
  CHECK(k::nearest_double(5, 1, -1075) == 0x1p-1073);
  // Rounded to 53 bits first, 2.5 smallest numbers less a little would become 2.5, and then 2 as it should; more
  // than that, 2.5 too, and then 2 instead of 3.
  const mpz_class one = mpz_class(1) << 80;
  CHECK(k::nearest_double(5 * one + 1, 2 * one, -1074) == 0x1.8p-1073);
  CHECK(k::nearest_double(5 * one - 1, 2 * one, -1074) == 0x1p-1073);
  const mpz_class half_a_step_up = (mpz_class(1) << 54) - 1;
  CHECK(k::nearest_double(2 * half_a_step_up - 1, 2, 970) == largest);
  CHECK(std::isinf(k::nearest_double(half_a_step_up, 1, 970)));
  CHECK(std::isinf(k::nearest_double(-1, 1, 1024)));
}

TEST_CASE("nearest_double_agrees_with_the_division_of_doubles") {
  Random random(75);
  for (int i = 0; i < 20'000; ++i) {
    const double n = std::nearbyint(uniform(random) * 0x1p53);
    const double d = std::nearbyint(std::ldexp(uniform(random, 1, 2), integer(random, 0, 52)));
    REQUIRE(k::nearest_double(mpz_class(n), mpz_class(d), 0) == n / d);
  }
}
