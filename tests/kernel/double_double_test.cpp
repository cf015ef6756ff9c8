// SPDX-License-Identifier: MIT
#include "leonhard/kernel/double_double.hpp"

#include <doctest/doctest.h>

#include <gmpxx.h>

#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using namespace leonhard::testing;

namespace {

mpq_class value(const k::DoubleDouble& x) { return mpq_class(x.high) + mpq_class(x.low); }

k::DoubleDouble number(Random& random) {
  return {k::fast_two_sum(any_exponent(random, 0, 4), any_exponent(random, -55, -50))};
}

/// |computed - exact| <= units u^2 |exact|, u = 2^-53.
bool within(const k::DoubleDouble& computed, const mpq_class& exact, double units) {
  const mpq_class error = abs(value(computed) - exact);
  return computed.high + computed.low == computed.high && error <= mpq_class(units * 0x1p-106) * abs(exact);
}

}  // namespace

TEST_CASE("double_double_arithmetic_keeps_its_error_bounds") {
  Random random(81);
  for (int i = 0; i < 50'000; ++i) {
    const k::DoubleDouble x = number(random), y = number(random);
    CAPTURE(x.high);
    CAPTURE(y.high);
    REQUIRE(within(x + y, value(x) + value(y), 3.001));
    REQUIRE(within(x - y, value(x) - value(y), 3.001));
    REQUIRE(within(x * y, value(x) * value(y), 7));
  }
}
