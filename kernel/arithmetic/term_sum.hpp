// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "leonhard/kernel/arithmetic/wide_double.hpp"
#include "leonhard/kernel/arithmetic/wide_integer.hpp"
#include "leonhard/kernel/sign.hpp"

/// The exact sign of a polynomial of any finite doubles: a sum of products of so many numbers each, of which the largest
/// are added first. Needs no memory: a sum is decided as soon as it is larger than all that is left to be added, and until
/// then fits a fixed number of bits, whatever the exponents.
namespace leonhard::kernel {

/// Plus or minus a product of numbers, given by their places in a list.
template <std::size_t Degree>
struct Term {
  std::array<std::uint8_t, Degree> factors;
  bool is_negative;
};

/// The sum of the terms in WideDouble numbers, or its bound.
template <std::size_t Degree, std::size_t Count, class Number, std::size_t Factors>
[[nodiscard]] constexpr Number sum_of(const std::array<Term<Degree>, Count>& terms,
                                      const std::array<Number, Factors>& factors) {
  std::array<Number, Count> products;
  for (std::size_t i = 0; i < Count; ++i) {
    Number product = factors[terms[i].factors[0]];
    for (std::size_t j = 1; j < Degree; ++j) product = product * factors[terms[i].factors[j]];
    products[i] = terms[i].is_negative ? -product : product;
  }
  return sum(products);
}

namespace detail {

/// Sorts by the 14 bits from `lowest_bit` on, above which there are none; the largest number first.
template <std::size_t Most>
void sort_down(std::array<std::uint32_t, Most>& numbers, std::size_t count, int lowest_bit) {
  if constexpr (Most < 20) {
    for (std::size_t i = 1; i < count; ++i)
      for (std::size_t j = i; j > 0 && numbers[j - 1] < numbers[j]; --j)
        std::swap(numbers[j - 1], numbers[j]);
  } else {  // twice by seven bits: no branch to foretell
    std::array<std::uint32_t, Most> other;
    const auto pass = [count](const auto& from, auto& to, int shift) {
      constexpr std::uint32_t mask = 127;
      std::array<std::uint32_t, mask + 1> places{};
      for (std::size_t i = 0; i < count; ++i) ++places[from[i] >> shift & mask];
      std::uint32_t before = 0;
      for (std::size_t digit = places.size(); digit-- > 0;) before += std::exchange(places[digit], before);
      for (std::size_t i = 0; i < count; ++i) to[places[from[i] >> shift & mask]++] = from[i];
    };
    pass(numbers, other, lowest_bit);
    pass(other, numbers, lowest_bit + 7);
  }
}

/// A mantissa times 2^52, without its sign.
struct IntegerFactor {
  std::uint64_t size;
  bool is_negative;
};

/// The product of 53-bit integers, without its sign.
template <std::size_t Limbs, std::size_t Degree, std::size_t Factors>
[[nodiscard]] WideInteger<Limbs> size_of_product(const std::array<std::uint8_t, Degree>& factors,
                                                 const std::array<IntegerFactor, Factors>& integers) {
  WideInteger<Limbs> product(static_cast<std::int64_t>(integers[factors[0]].size));
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (product.template multiply<(53 * (I + 1) + 63) / 64>(integers[factors[I + 1]].size), ...);
  }
  (std::make_index_sequence<Degree - 1>());
  return product;
}

}  // namespace detail

/// The sign of the sum of the terms, exact.
///
/// factors  made by wide(): the numbers that the terms name
/// Cost: the terms are sorted by their exponents; then each of them, from the largest down, costs a product of Degree
/// integers, until the sign is known. Points of mixed exponents take two or three, ties all.
///
/// All products are integers below 2^bits times 2^e, e the sum of the factors' exponents and a constant. Say that the
/// sum of those with the exponents so far is s 2^e, and that the next exponent is e - drop. All terms that are left,
/// fewer than 2^rest_bits, are together less than 2^(bits + rest_bits) 2^(e - drop), so if |s| 2^drop is at least
/// 2^(bits + rest_bits) the sign is known. Otherwise s 2^drop is below that, so with one term more it has at most
/// bits + rest_bits + 1 bits, and its sign.
template <std::size_t Degree, std::size_t Count, std::size_t Factors>
[[nodiscard]] Sign sign_of_sum(const std::array<Term<Degree>, Count>& terms,
                               const std::array<WideDouble, Factors>& factors) {
  constexpr int bits = 53 * Degree, rest_bits = std::bit_width(Count);
  constexpr std::size_t limbs = (bits + rest_bits + 2 + 63) / 64;

  // Exponents, made positive, with the term's place in the low bits.
  constexpr int lowest = -static_cast<int>(Degree) * 1074;
  static_assert(Degree * (1023 + 1074) < (1U << 14) && 14 + rest_bits <= 32);
  std::array<std::uint32_t, Count> order;
  std::size_t count = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    int exponent = 0;
    for (const std::uint8_t factor : terms[i].factors) exponent += factors[factor].exponent;
    if (exponent >= lowest)  // else a factor is 0
      order[count++] =
          static_cast<std::uint32_t>(exponent - lowest) << rest_bits | static_cast<std::uint32_t>(i);
  }
  detail::sort_down(order, count, rest_bits);

  std::array<detail::IntegerFactor, Factors> integers;
  for (std::size_t i = 0; i < Factors; ++i)
    integers[i] = {static_cast<std::uint64_t>(std::abs(factors[i].mantissa) * 0x1p52),
                   factors[i].mantissa < 0};

  WideInteger<limbs> whole(std::int64_t{0});
  int last_exponent = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto exponent = static_cast<int>(order[i] >> rest_bits);
    if (const int drop = last_exponent - exponent; drop != 0) {
      if (const Sign sign = whole.sign(); sign != Sign::zero) {
        if (whole.bit_width() - 1 + drop >= bits + rest_bits) return sign;
        whole.shift_left(drop);
      }
      last_exponent = exponent;
    }
    const Term<Degree>& term = terms[order[i] & ((1U << rest_bits) - 1)];
    bool is_negative = term.is_negative;
    for (const std::uint8_t factor : term.factors) is_negative = is_negative != integers[factor].is_negative;
    const auto size = detail::size_of_product<limbs>(term.factors, integers);
    whole = is_negative ? whole - size : whole + size;
  }
  return whole.sign();
}

}  // namespace leonhard::kernel
