// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <limits>
#include <optional>

#include "leonhard/kernel/arithmetic/expansion.hpp"
#include "leonhard/kernel/arithmetic/long_expansion.hpp"

/// Two kinds of numbers in which a homogeneous polynomial in differences of coordinates is evaluated exactly:
/// expansions where they are safe and short, GMP's integers everywhere. Formulas take either as a template parameter `Numbers`, which has
/// the type Number and makes a Number of two coordinates.
namespace leonhard::kernel {

struct Expansions {
  using Number = LongExpansion;
  [[nodiscard]] LongExpansion difference(double a, double b) const {
    return LongExpansion(two_difference(a, b));
  }
  [[nodiscard]] LongExpansion one() const { return LongExpansion(1); }
};

/// All coordinates are divided by 2^unit, which makes integers of them if no bit is below.
struct Integers {
  using Number = mpz_class;
  int unit;

  [[nodiscard]] mpz_class integer(double x) const;
  [[nodiscard]] mpz_class difference(double a, double b) const { return integer(a) - integer(b); }
  [[nodiscard]] mpz_class one() const { return 1; }
};

/// The exponents of the lowest and the highest bit that is set in any of some doubles; empty, lowest above highest, if
/// all are 0.
struct BitRange {
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();

  [[nodiscard]] bool is_empty() const { return lowest > highest; }
  void include(double finite);
};

/// By which power of two are coordinates to be multiplied so that a polynomial of them is exact in expansions?
///
/// degree   of the polynomial, at most 400: a sum of at most 4^degree products of so many differences of coordinates;
///          the polynomials on the way to it are of the same kind and of lower degree
/// returns  the exponent, 0 if that will do; none if the polynomial is of more than 256 bits, for then GMP is quicker
///
/// Every number on the way is a multiple of 2^(degree lowest), which must be representable: at least 2^-1074. A
/// difference is below 2^(highest + 2), a sum of 4^degree products below 2^(degree (highest + 4)), and splitting
/// multiplies by 2^28: the whole must stay below 2^1023. 256 bits have room between these ends.
[[nodiscard]] std::optional<int> expansion_shift(BitRange bits, int degree);

}  // namespace leonhard::kernel
