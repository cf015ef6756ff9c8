// SPDX-License-Identifier: MIT
#include "leonhard/kernel/arithmetic/exact_numbers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace leonhard::kernel {
namespace {

/// x = mantissa 2^exponent with an odd mantissa, of x other than 0 and without its sign.
struct OddMantissa {
  std::uint64_t mantissa;
  int exponent;
};

OddMantissa odd_mantissa(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffff;
  const std::uint64_t mantissa = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  const int zeros = std::countr_zero(mantissa);
  return {mantissa >> zeros, std::max(biased, 1) - 1075 + zeros};
}

}  // namespace

mpz_class Integers::integer(double x) const {
  mpz_class value;
  if (x == 0) return value;
  const auto [mantissa, exponent] = odd_mantissa(x);
  value = static_cast<unsigned long>(mantissa);
  value <<= static_cast<mp_bitcnt_t>(exponent - unit);
  if (x < 0) value = -value;
  return value;
}

void BitRange::include(double finite) {
  if (finite == 0) return;
  const auto [mantissa, exponent] = odd_mantissa(finite);
  lowest = std::min(lowest, exponent);
  highest = std::max(highest, exponent + static_cast<int>(std::bit_width(mantissa)) - 1);
}

std::optional<int> expansion_shift(BitRange bits, int degree) {
  constexpr int most_bits = 256;
  if (bits.is_empty()) return 0;
  if (degree * (bits.highest - bits.lowest + 1) > most_bits) return {};
  const int lowest = -(1074 / degree), highest = (1023 - 28) / degree - 4;
  if (bits.lowest >= lowest && bits.highest <= highest) return 0;
  return highest - bits.highest;
}

}  // namespace leonhard::kernel
