// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "leonhard/kernel/sign.hpp"
#include "leonhard/kernel/filtered_sign.hpp"

/// Floating point whose exponents stand apart, so that polynomials of any finite doubles neither over- nor underflow.
///
/// A sum takes the highest exponent of its terms and is not normalised (block floating point): its mantissa is small, or
/// 0, if the terms cancel. So no mantissa exceeds a size that the formula alone decides, nor does its error, counted in
/// units of 2^exponent: a bound that is a constant of the formula. It is found by evaluating the formula, a template in
/// the type of number, with WideBound.
namespace leonhard::kernel {

/// mantissa 2^exponent.
struct WideDouble {
  double mantissa;
  int exponent;
};

/// The exponent of 0: below those of all products of up to 100 doubles other than 0, and so are those of its products.
inline constexpr int zero_exponent = -(1 << 20);

/// x itself, 1 <= |mantissa| < 2 unless x is 0.
[[nodiscard]] inline WideDouble wide(double x) {
  constexpr int bias = 1023, fraction_bits = 52;
  constexpr std::uint64_t exponent_mask = std::uint64_t{0x7ff} << fraction_bits;
  int shift = 0;
  auto bits = std::bit_cast<std::uint64_t>(x);
  if ((bits & exponent_mask) == 0) [[unlikely]] {  // 0 or subnormal
    if (x == 0) return {0, zero_exponent};
    shift = 64;
    bits = std::bit_cast<std::uint64_t>(x * 0x1p64);
  }
  const auto biased = static_cast<int>((bits & exponent_mask) >> fraction_bits);
  return {std::bit_cast<double>((bits & ~exponent_mask) | std::uint64_t{bias} << fraction_bits),
          biased - bias - shift};
}

[[nodiscard]] inline WideDouble operator-(const WideDouble& x) { return {-x.mantissa, x.exponent}; }

[[nodiscard]] inline WideDouble operator*(const WideDouble& x, const WideDouble& y) {
  return {x.mantissa * y.mantissa, x.exponent + y.exponent};
}

namespace detail {

/// Terms that are farther below the highest exponent are taken to be that far below it.
inline constexpr int most_drop = 900;

}  // namespace detail

template <std::size_t Count>
[[nodiscard]] inline WideDouble sum(const std::array<WideDouble, Count>& terms) {
  constexpr int bias = 1023, fraction_bits = 52;
  int exponent = terms[0].exponent;
  for (const WideDouble& term : terms) exponent = std::max(exponent, term.exponent);
  double mantissa = 0;
  for (const WideDouble& term : terms) {
    const int power = std::max(term.exponent - exponent, -detail::most_drop);
    mantissa +=
        term.mantissa * std::bit_cast<double>(static_cast<std::uint64_t>(power + bias) << fraction_bits);
  }
  return {mantissa, exponent};
}

/// What is known of a WideDouble: |mantissa| <= size, and it stands for a number (mantissa + d) 2^exponent with
/// |d| <= error. Made by the same operations, when the program is compiled.
///
/// u = 2^-53. What underflows, in a product or in a term that a sum scales, is wrong by less than 2^-1074. A term that a
/// sum takes to be 2^-900 below the highest one, where it is farther below, is wrong by its size and its mantissa's
/// size and error at that scale. 2^-800 is above all of that for sizes up to 2^90. The factors 1 + 2^-40 make up for
/// terms in u^2 and for the rounding of the bounds themselves.
struct WideBound {
  double size, error;
};

/// What is known of wide(x).
inline constexpr WideBound wide_bound{2, 0};

[[nodiscard]] constexpr WideBound operator-(const WideBound& x) { return x; }

[[nodiscard]] constexpr WideBound operator*(const WideBound& x, const WideBound& y) {
  constexpr double u = 0x1p-53, slack = 1 + 0x1p-40;
  const double size = x.size * y.size * slack;
  return {size, (x.size * y.error + x.error * y.size + x.error * y.error + u * size) * slack + 0x1p-800};
}

template <std::size_t Count>
[[nodiscard]] constexpr WideBound sum(const std::array<WideBound, Count>& terms) {
  constexpr double u = 0x1p-53, slack = 1 + 0x1p-40;
  WideBound whole{0, 0};
  for (const WideBound& term : terms) {
    whole.size += term.size * slack;
    whole.error += term.error * slack;
  }
  whole.error = (whole.error + (Count - 1) * u * whole.size) * slack + 0x1p-800;
  return whole;
}

/// The sign of a number whose error is at most `error` 2^exponent, if that is enough to know it.
[[nodiscard]] inline FilteredSign certain_sign(const WideDouble& x, double error) {
  return sign_if_beyond(x.mantissa, error);
}

}  // namespace leonhard::kernel
