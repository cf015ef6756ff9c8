// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "leonhard/kernel/sign.hpp"

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "leonhard: expansion arithmetic cannot be compiled with -ffast-math or a part of it"
#endif

/// Exact arithmetic on sums of doubles: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and
/// fast robust geometric predicates", Discrete & Computational Geometry 18 (1997). Theorem numbers are his.
///
/// Exact as long as nothing overflows and no product falls below 2^-1074 in its lowest bit; callers make sure
/// of the range. Needs round-to-nearest and -ffp-contract=off in the including file.
namespace leonhard::kernel {

/// high + low is the exact result of an operation, high its rounding.
struct TwoTerms {
  double high, low;
};

/// Theorem 7 (Knuth).
[[nodiscard]] inline TwoTerms two_sum(double a, double b) {
  const double sum = a + b;
  const double b_virtual = sum - a, a_virtual = sum - b_virtual;
  return {sum, (a - a_virtual) + (b - b_virtual)};
}

/// Theorem 6 (Dekker): |a| >= |b| or a = 0.
[[nodiscard]] inline TwoTerms fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

[[nodiscard]] inline TwoTerms two_difference(double a, double b) { return two_sum(a, -b); }

/// Theorem 17 (Dekker, Veltkamp): a = high + low with at most 26 bits each, so that products of halves are
/// exact.
[[nodiscard]] inline TwoTerms split(double a) {
  const double scaled = 0x8000001p0 * a;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// Theorem 18, with b split beforehand. Portable: std::fma falls back to slow software where the processor
/// has none.
[[nodiscard]] inline TwoTerms two_product(double a, double b, TwoTerms b_halves) {
  const double product = a * b;
  const TwoTerms a_halves = split(a);
  const double error = ((a_halves.high * b_halves.high - product) + a_halves.high * b_halves.low +
                        a_halves.low * b_halves.high);
  return {product, a_halves.low * b_halves.low + error};
}

[[nodiscard]] inline TwoTerms two_product(double a, double b) { return two_product(a, b, split(b)); }

/// No expansion has more terms: they do not overlap, so each has a bit to itself, from 2^1023 down to 2^-1074.
inline constexpr std::size_t most_terms = 1024 + 1074;

/// The room that so many terms need at most.
[[nodiscard]] constexpr std::size_t capacity_for(std::size_t terms) { return std::min(terms, most_terms); }

/// The exact sum of up to Capacity doubles: non-overlapping, none of them zero, smallest first.
///
/// Zeros are left out as they arise, so that the cost follows the length that the numbers really have:
/// products of small integers stay one term long.
template <std::size_t Capacity>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(TwoTerms value) {
    static_assert(Capacity >= 2);
    append(value.low);
    append(value.high);
  }
  /// The same value with room for more terms.
  template <std::size_t Smaller>
  explicit Expansion(const Expansion<Smaller>& value) {
    static_assert(Smaller < Capacity);
    for (std::size_t i = 0; i < value.size(); ++i) append(value[i]);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double operator[](std::size_t i) const { return terms_[i]; }

  /// The largest term has the sign of the sum.
  [[nodiscard]] Sign sign() const { return size_ == 0 ? Sign::zero : sign_of(terms_[size_ - 1]); }

  /// term must not overlap the terms so far and be larger than they are, or zero.
  void append(double term) {
    if (term == 0) return;
    assert(size_ < Capacity);
    terms_[size_++] = term;
  }

  [[nodiscard]] Expansion operator-() const {
    Expansion negated;
    for (std::size_t i = 0; i < size_; ++i) negated.append(-terms_[i]);
    return negated;
  }

 private:
  std::array<double, Capacity> terms_;
  std::size_t size_ = 0;
};

/// Theorem 10, grow expansion: one number more.
template <std::size_t N>
[[nodiscard]] Expansion<capacity_for(N + 1)> grow(const Expansion<N>& e, double number) {
  Expansion<capacity_for(N + 1)> sum;
  double rest = number;
  for (std::size_t i = 0; i < e.size(); ++i) {
    const TwoTerms partial = two_sum(rest, e[i]);
    sum.append(partial.low);
    rest = partial.high;
  }
  sum.append(rest);
  return sum;
}

/// Theorem 23, compress: the same value in as few terms as its bits allow or nearly so. The largest term then is within
/// one unit in its last place of the value.
template <std::size_t N>
[[nodiscard]] Expansion<N> compress(const Expansion<N>& e) {
  if (e.size() == 0) return {};
  std::array<double, N> downward;  // from the back
  std::size_t front = N;
  double rest = e[e.size() - 1];
  for (std::size_t i = e.size() - 1; i-- > 0;) {
    const TwoTerms partial = fast_two_sum(rest, e[i]);
    rest = partial.high;
    if (partial.low != 0) {
      downward[--front] = partial.high;
      rest = partial.low;
    }
  }
  Expansion<N> compressed;
  for (std::size_t i = front; i < N; ++i) {
    const TwoTerms partial = fast_two_sum(downward[i], rest);
    compressed.append(partial.low);
    rest = partial.high;
  }
  compressed.append(rest);
  return compressed;
}

/// Theorem 13, fast expansion sum: merge by magnitude, then one running two_sum.
template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<capacity_for(N + M)> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<capacity_for(N + M)> sum;
  double rest = 0;
  std::size_t i = 0, j = 0;
  while (i < e.size() || j < f.size()) {
    const bool from_e = j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j]));
    const TwoTerms partial = two_sum(rest, from_e ? e[i++] : f[j++]);
    sum.append(partial.low);
    rest = partial.high;
  }
  sum.append(rest);
  return sum;
}

template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<capacity_for(N + M)> operator-(const Expansion<N>& e, const Expansion<M>& f) {
  return e + -f;
}

/// Theorem 19, scale expansion.
template <std::size_t N>
[[nodiscard]] Expansion<capacity_for(2 * N)> operator*(const Expansion<N>& e, double factor) {
  Expansion<capacity_for(2 * N)> product;
  if (e.size() == 0 || factor == 0) return product;
  const TwoTerms halves = split(factor);
  double rest = 0;
  for (std::size_t i = 0; i < e.size(); ++i) {
    const TwoTerms term = two_product(e[i], factor, halves);
    const TwoTerms low_sum = two_sum(rest, term.low);
    product.append(low_sum.low);
    const TwoTerms high_sum = fast_two_sum(term.high, low_sum.high);
    product.append(high_sum.low);
    rest = high_sum.high;
  }
  product.append(rest);
  return product;
}

/// The sum of e f[i] over the next Terms of f from `begin` on, by halves: a term passes through log2(Terms)
/// additions, and halves that f does not reach cost nothing.
template <std::size_t Terms, std::size_t N, std::size_t M>
[[nodiscard]] Expansion<capacity_for(2 * N * Terms)> partial_product(const Expansion<N>& e,
                                                                     const Expansion<M>& f,
                                                                     std::size_t begin) {
  if constexpr (Terms == 1) {
    return e * f[begin];
  } else {
    constexpr std::size_t half = Terms / 2;
    if (f.size() <= begin + half)
      return Expansion<capacity_for(2 * N * Terms)>(partial_product<half>(e, f, begin));
    return partial_product<half>(e, f, begin) + partial_product<Terms - half>(e, f, begin + half);
  }
}

/// Exact product; cheapest if f is the shorter one.
template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<capacity_for(2 * N * M)> operator*(const Expansion<N>& e, const Expansion<M>& f) {
  if (f.size() == 0) return {};
  return partial_product<M>(e, f, 0);
}

}  // namespace leonhard::kernel
