// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "leonhard/kernel/pair.hpp"

/// When a determinant needs no error bound: among points of a coarse grid floating-point arithmetic is exact.
namespace leonhard::kernel {

/// Is every coordinate a multiple of one number u, a power of two, and every difference at most 2^Bits u in size? A
/// polynomial of the differences is then exact in floating point if its value and partial sums are below 2^53 for
/// differences of 2^Bits, and if its degree is 5 at most: the largest difference is between 2^-190 and 2^190, so that
/// nothing over- or underflows.
///
/// Differences, rounded as they are, may be given: a multiple of u below 2^53 u is its own rounding.
template <int Bits, std::size_t Differences, std::size_t Coordinates>
[[nodiscard]] inline bool are_small_multiples(const std::array<Pair, Differences>& differences,
                                              const std::array<Pair, Coordinates>& coordinates) {
  Pair sizes = absolute(differences[0]);
  for (std::size_t i = 1; i < Differences; ++i) {
    const Pair size = absolute(differences[i]);
    sizes = sizes > size ? sizes : size;
  }
  const double largest = std::max(sizes[0], sizes[1]);
  if (!(largest > 0x1p-190 && largest < 0x1p190)) return false;

  constexpr int bias = 1023, fraction_bits = 52;
  const auto power_of_two = [](std::int64_t exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + bias) << fraction_bits);
  };
  const std::int64_t exponent = (std::bit_cast<std::int64_t>(largest) >> fraction_bits) - bias;
  const double u = power_of_two(exponent + 1 - Bits), inverse = power_of_two(Bits - 1 - exponent);

  constexpr double rounder = 0x1.8p52;  // what it is added to loses its fraction
  using Mask = long long __attribute__((vector_size(16)));
  Mask equal{-1, -1};
  for (const Pair c : coordinates) {
    const Pair whole = (c * inverse + rounder) - rounder;
    equal &= whole * u == c;
  }
  return (equal[0] & equal[1]) != 0;
}

}  // namespace leonhard::kernel
