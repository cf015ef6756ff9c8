// SPDX-License-Identifier: MIT
#include "leonhard/kernel/arithmetic/wide_double.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using leonhard::Sign;
using namespace leonhard::testing;

namespace {

mpq_class power_of_two(int exponent) {
  mpq_class power = 1;
  if (exponent > 0) power <<= static_cast<mp_bitcnt_t>(exponent);
  if (exponent < 0) power >>= static_cast<mp_bitcnt_t>(-exponent);
  return power;
}

mpq_class value(const k::WideDouble& x) {
  return x.mantissa == 0 ? mpq_class(0) : mpq_class(mpq_class(x.mantissa) * power_of_two(x.exponent));
}

/// A number, what is known of it, and the number that it stands for.
struct Checked {
  k::WideDouble computed;
  k::WideBound bound;
  mpq_class exact;
};

Checked any_number(Random& random, int lowest, int highest) {
  const double x = integer(random, 0, 9) == 0 ? 0 : any_exponent(random, lowest, highest);
  return {k::wide(x), k::wide_bound, mpq_class(x)};
}

Checked product(const Checked& x, const Checked& y) {
  return {x.computed * y.computed, x.bound * y.bound, x.exact * y.exact};
}

Checked sum_of_three(const Checked& x, const Checked& y, const Checked& z) {
  return {sum(std::array{x.computed, y.computed, -z.computed}), sum(std::array{x.bound, y.bound, -z.bound}),
          x.exact + y.exact - z.exact};
}

/// The error as a part of its bound.
double check(const Checked& x) {
  REQUIRE(std::abs(x.computed.mantissa) <= x.bound.size);
  if (x.computed.exponent < k::zero_exponent / 2) {
    REQUIRE(x.exact == 0);
    return 0;
  }
  const mpq_class error = abs(value(x.computed) - x.exact) / power_of_two(x.computed.exponent);
  REQUIRE(error <= mpq_class(x.bound.error));
  return x.bound.error == 0 ? 0 : mpq_class(error / mpq_class(x.bound.error)).get_d();
}

}  // namespace

TEST_CASE("every_double_becomes_a_wide_double_of_the_same_value") {
  Random random(92);
  std::vector<double> numbers{0,
                              -0.0,
                              1,
                              -1,
                              std::nextafter(2.0, 0.0),
                              std::numeric_limits<double>::max(),
                              std::numeric_limits<double>::min(),
                              -std::nextafter(std::numeric_limits<double>::min(), 0.0),
                              std::numeric_limits<double>::denorm_min()};
  for (int i = 0; i < 2'000; ++i) numbers.push_back(any_exponent(random, -1074, 1024));
  for (const double x : numbers) {
    CAPTURE(x);
    const k::WideDouble number = k::wide(x);
    REQUIRE(value(number) == mpq_class(x));
    if (x == 0) continue;
    REQUIRE(std::abs(number.mantissa) >= 1);
    REQUIRE(std::abs(number.mantissa) < 2);
  }
}

TEST_CASE("wide_arithmetic_keeps_its_error_bounds") {
  Random random(93);
  double worst = 0;
  const int calls = scaled_calls(20'000);
  for (int i = 0; i < calls; ++i) {
    const int spread = std::array{0, 2, 60, 1000}[static_cast<std::size_t>(integer(random, 0, 3))];
    const int middle = integer(random, spread - 1074, 1024 - spread);
    std::vector<Checked> numbers;
    for (int j = 0; j < 4; ++j) numbers.push_back(any_number(random, middle - spread, middle + spread));
    for (int step = 0; step < 5; ++step) {
      const auto any = [&]() -> const Checked& {
        return numbers[static_cast<std::size_t>(integer(random, 0, static_cast<int>(numbers.size()) - 1))];
      };
      const bool multiplies = integer(random, 0, 1) == 0;
      const Checked result = multiplies ? product(any(), any()) : sum_of_three(any(), any(), any());
      CAPTURE(i);
      worst = std::max(worst, check(result));
      numbers.push_back(result);
    }
  }
  CHECK(worst > 0.1);  // the bounds are not so wide that an error in them would not show
}

TEST_CASE("sums_of_wide_doubles_take_the_highest_exponent") {
  const k::WideDouble one = k::wide(1), tiny = k::wide(0x1p-1074), zero = k::wide(0);
  const k::WideDouble whole = sum(std::array{tiny * tiny, one, zero});
  CHECK(whole.exponent == 0);
  CHECK(whole.mantissa == 1);
  CHECK(sum(std::array{one, -one, tiny}).exponent == 0);
  CHECK(k::certain_sign(sum(std::array{zero, zero * one, zero}), 0x1p-52).is_certain() == false);
  CHECK(*k::certain_sign(tiny * -tiny, 0x1p-52) == Sign::negative);
}
