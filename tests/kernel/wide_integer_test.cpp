// SPDX-License-Identifier: MIT
#include "leonhard/kernel/arithmetic/wide_integer.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace k = leonhard::kernel;
using k::WideInteger;
using leonhard::Sign;

namespace {

using Random = std::mt19937_64;

template <std::size_t Limbs>
mpz_class value_of(const WideInteger<Limbs>& x) {
  mpz_class value = 0;
  for (std::size_t i = Limbs; i-- > 0;) value = (value << 64) + mpz_class(std::to_string(x.limb(i)));
  if (x.is_negative()) value -= mpz_class(1) << (64 * Limbs);
  return value;
}

/// Limbs that are often all zeros or all ones, so that carries and borrows run far.
template <std::size_t Limbs>
WideInteger<Limbs> any_integer(Random& random) {
  WideInteger<Limbs> x(std::int64_t{0});
  for (std::size_t i = 0; i < Limbs; ++i) {
    const std::uint64_t bits = random();
    x.limb(i) = random() % 4 == 0 ? 0 : random() % 3 == 0 ? ~std::uint64_t{0} : bits >> random() % 64;
  }
  return x;
}

/// The value that 64 Limbs bits hold of any other.
template <std::size_t Limbs>
mpz_class wrapped(const mpz_class& value) {
  const mpz_class modulus = mpz_class(1) << (64 * Limbs);
  mpz_class rest;
  mpz_fdiv_r_2exp(rest.get_mpz_t(), value.get_mpz_t(), 64 * Limbs);
  return rest >= modulus / 2 ? mpz_class(rest - modulus) : rest;
}

template <std::size_t N, std::size_t M>
void check_against_gmp() {
  Random random(N * 8 + M);
  for (int i = 0; i < 20'000; ++i) {
    const auto x = any_integer<N>(random), y = any_integer<N>(random);
    const auto z = any_integer<M>(random);
    REQUIRE(value_of(x + y) == wrapped<N>(value_of(x) + value_of(y)));
    REQUIRE(value_of(x - y) == wrapped<N>(value_of(x) - value_of(y)));
    REQUIRE(value_of(x * z) == value_of(x) * value_of(z));
    REQUIRE(x.sign() == leonhard::sign_of(value_of(x)));
  }
}

}  // namespace

TEST_CASE("wide_integers_add_and_multiply_as_gmp_does") {
  check_against_gmp<1, 1>();
  check_against_gmp<2, 1>();
  check_against_gmp<2, 2>();
  check_against_gmp<3, 2>();
  check_against_gmp<4, 1>();
}

TEST_CASE("wide_integers_shift_and_count_their_bits_as_gmp_does") {
  Random random(98);
  for (int i = 0; i < 20'000; ++i) {
    const auto x = any_integer<3>(random);
    const mpz_class value = value_of(x), size = x.is_negative() ? mpz_class(-value - 1) : value;
    REQUIRE(x.bit_width() == (size == 0 ? 0 : static_cast<int>(mpz_sizeinbase(size.get_mpz_t(), 2))));
    const auto places = static_cast<int>(random() % 4 == 0 ? 64 * (random() % 3) : random() % 192);
    auto shifted = x;
    shifted.shift_left(places);
    REQUIRE(value_of(shifted) == wrapped<3>(value << static_cast<mp_bitcnt_t>(places)));
  }
}

TEST_CASE("wide_integers_grow_by_factors_of_a_limb") {
  Random random(99);
  for (int i = 0; i < 20'000; ++i) {
    const auto two = any_integer<2>(random);
    WideInteger<4> x(std::int64_t{0});
    x.limb(0) = two.limb(0);
    x.limb(1) = two.limb(1);
    const mpz_class value = value_of(x);
    const std::uint64_t factor = any_integer<1>(random).limb(0);
    x.multiply<2>(factor);
    REQUIRE(value_of(x) == value * mpz_class(std::to_string(factor)));
  }
}

TEST_CASE("wide_integers_hold_their_extremes") {
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min(),
                         most = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t x : {least, most, std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}})
    for (const std::int64_t y : {least, most, std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}}) {
      const mpz_class product = mpz_class(std::to_string(x)) * mpz_class(std::to_string(y));
      CHECK(value_of(WideInteger<1>(x) * WideInteger<1>(y)) == product);
      CHECK(value_of(WideInteger<2>(k::detail::Int128{x} * y)) == product);
      CHECK(value_of(WideInteger<2>(x) * WideInteger<1>(y)) == product);
    }
}
