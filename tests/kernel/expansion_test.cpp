// SPDX-License-Identifier: MIT
#include "leonhard/kernel/arithmetic/expansion.hpp"

#include <doctest/doctest.h>

#include <gmpxx.h>

#include <cmath>
#include <cstddef>

#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using leonhard::sign_of;
using namespace leonhard::testing;

namespace {

mpq_class value(k::TwoTerms t) { return mpq_class(t.high) + mpq_class(t.low); }

template <std::size_t Capacity>
mpq_class value(const k::Expansion<Capacity>& e) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < e.size(); ++i) sum += mpq_class(e[i]);
  return sum;
}

/// Terms grow, none is zero, and no term reaches down to the highest bit of the one below it.
template <std::size_t Capacity>
bool well_formed(const k::Expansion<Capacity>& e) {
  for (std::size_t i = 0; i < e.size(); ++i) {
    if (e[i] == 0) return false;
    if (i == 0) continue;
    const double unit = std::ldexp(1.0, std::ilogb(e[i - 1]) + 1);
    if (std::fmod(e[i], unit) != 0) return false;
  }
  return true;
}

double number(Random& random) {
  return integer(random, 0, 3) == 0 ? double(integer(random, -9, 9)) : any_exponent(random, -60, 60);
}

k::Expansion<2> pair(Random& random) { return k::Expansion<2>(k::two_sum(number(random), number(random))); }

}  // namespace

TEST_CASE("two_sum_and_two_product_lose_nothing") {
  Random random(51);
  for (int i = 0; i < 50'000; ++i) {
    const double a = number(random), b = number(random);
    CAPTURE(a);
    CAPTURE(b);
    REQUIRE(value(k::two_sum(a, b)) == mpq_class(a) + mpq_class(b));
    REQUIRE(value(k::two_difference(a, b)) == mpq_class(a) - mpq_class(b));
    REQUIRE(value(k::two_product(a, b)) == mpq_class(a) * mpq_class(b));
    REQUIRE(k::two_product(a, b).high == a * b);
  }
}

TEST_CASE("expansions_add_subtract_and_multiply_exactly") {
  Random random(52);
  for (int i = 0; i < 10'000; ++i) {
    const auto a = pair(random), b = pair(random), c = pair(random), d = pair(random);
    const auto ab = a * b, cd = c * d;
    const auto sum = ab + cd, difference = ab - cd;
    const auto product = sum * difference;
    REQUIRE(value(ab) == value(a) * value(b));
    REQUIRE(value(sum) == value(ab) + value(cd));
    REQUIRE(value(difference) == value(ab) - value(cd));
    REQUIRE(value(product) == value(sum) * value(difference));
    REQUIRE(well_formed(product));
    REQUIRE(product.sign() == sign_of(value(product)));
    REQUIRE((-product).sign() == -product.sign());
  }
}

TEST_CASE("expansions_that_cancel_have_no_terms") {
  Random random(53);
  for (int i = 0; i < 1000; ++i) {
    const auto a = pair(random), b = pair(random);
    const auto zero = a * b - b * a;
    REQUIRE(zero.size() == 0);
    REQUIRE(zero.sign() == leonhard::Sign::zero);
    REQUIRE((zero * a).size() == 0);
    REQUIRE((a * zero).size() == 0);
  }
}

TEST_CASE("grow_adds_one_number_exactly") {
  Random random(53);
  for (int i = 0; i < 20'000; ++i) {
    const auto e = pair(random) * pair(random);
    const double x = integer(random, 0, 2) == 0 && e.size() > 0 ? -e[0] : number(random);
    const auto sum = k::grow(e, x);
    REQUIRE(value(sum) == value(e) + mpq_class(x));
    REQUIRE(well_formed(sum));
  }
}

TEST_CASE("compress_keeps_the_value_in_fewer_terms_and_its_largest_is_a_rounding") {
  Random random(54);
  std::size_t terms = 0, compressed_terms = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto e = pair(random) * pair(random) - pair(random) * pair(random);
    const auto compressed = k::compress(e);
    REQUIRE(value(compressed) == value(e));
    REQUIRE(well_formed(compressed));
    REQUIRE(compressed.size() <= e.size());
    terms += e.size();
    compressed_terms += compressed.size();
    if (compressed.size() == 0) continue;
    const double largest = compressed[compressed.size() - 1];
    const mpq_class error = value(e) - mpq_class(largest);
    REQUIRE(abs(error) <= mpq_class(std::ldexp(1.0, std::ilogb(largest) - 52)));
  }
  CHECK(compressed_terms < terms);
}
