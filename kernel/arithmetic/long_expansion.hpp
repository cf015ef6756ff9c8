// SPDX-License-Identifier: MIT
#pragma once

#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

#include "leonhard/kernel/arithmetic/expansion.hpp"
#include "leonhard/kernel/sign.hpp"

namespace leonhard::kernel {

/// The exact sum of doubles as in expansion.hpp, of as many terms as it takes: for polynomials whose degree is known
/// only when the program runs. Same conditions on the range.
///
/// Products are compressed (Shewchuk's theorem 23), which leaves about one term for each 53 bits between the highest
/// and the lowest one that is set: those of small integers stay one or two terms long, whatever the degree.
class LongExpansion {
 public:
  LongExpansion() = default;
  explicit LongExpansion(double value) { append(value); }
  explicit LongExpansion(TwoTerms value) {
    append(value.low);
    append(value.high);
  }

  [[nodiscard]] std::size_t size() const { return terms_.size(); }
  [[nodiscard]] friend Sign sign_of(const LongExpansion& e) {
    return e.terms_.empty() ? Sign::zero : leonhard::sign_of(e.terms_.back());
  }

  /// Theorem 13, fast expansion sum.
  [[nodiscard]] friend LongExpansion operator+(const LongExpansion& e, const LongExpansion& f) {
    return sum(e, f, 1);
  }
  [[nodiscard]] friend LongExpansion operator-(const LongExpansion& e, const LongExpansion& f) {
    return sum(e, f, -1);
  }

  [[nodiscard]] friend LongExpansion operator*(const LongExpansion& e, const LongExpansion& f) {
    if (e.size() == 0 || f.size() == 0) return {};
    return (e.size() < f.size() ? f.times(e, 0, e.size()) : e.times(f, 0, f.size())).compressed();
  }

 private:
  void append(double term) {
    if (term != 0) terms_.push_back(term);
  }

  /// e + sign_of_f f.
  static LongExpansion sum(const LongExpansion& e, const LongExpansion& f, double sign_of_f) {
    LongExpansion sum;
    sum.terms_.reserve(e.size() + f.size());
    double rest = 0;
    for (std::size_t i = 0, j = 0; i < e.size() || j < f.size();) {
      const bool from_e = j == f.size() || (i < e.size() && std::abs(e.terms_[i]) < std::abs(f.terms_[j]));
      const TwoTerms partial = two_sum(rest, from_e ? e.terms_[i++] : sign_of_f * f.terms_[j++]);
      sum.append(partial.low);
      rest = partial.high;
    }
    sum.append(rest);
    return sum;
  }

  /// Theorem 19, scale expansion.
  [[nodiscard]] LongExpansion times(double factor) const {
    LongExpansion product;
    product.terms_.reserve(2 * size());
    const TwoTerms halves = split(factor);
    double rest = 0;
    for (const double term : terms_) {
      const TwoTerms scaled = two_product(term, factor, halves);
      const TwoTerms low_sum = two_sum(rest, scaled.low);
      product.append(low_sum.low);
      const TwoTerms high_sum = fast_two_sum(scaled.high, low_sum.high);
      product.append(high_sum.low);
      rest = high_sum.high;
    }
    product.append(rest);
    return product;
  }

  /// The sum of the products with the terms [begin, end) of f, by halves.
  [[nodiscard]] LongExpansion times(const LongExpansion& f, std::size_t begin, std::size_t end) const {
    if (end - begin == 1) return times(f.terms_[begin]);
    const std::size_t middle = begin + (end - begin) / 2;
    return times(f, begin, middle) + times(f, middle, end);
  }

  /// Theorem 23: from the largest term down, then up again.
  [[nodiscard]] LongExpansion compressed() && {
    if (size() < 2) return std::move(*this);
    double rest = terms_.back();
    std::size_t bottom = size();
    for (std::size_t i = size() - 1; i-- > 0;) {
      const TwoTerms partial = fast_two_sum(rest, terms_[i]);
      rest = partial.high;
      if (partial.low != 0) {
        terms_[--bottom] = rest;
        rest = partial.low;
      }
    }
    terms_[--bottom] = rest;
    std::size_t top = 0;
    for (std::size_t i = bottom + 1; i < size(); ++i) {
      const TwoTerms partial = fast_two_sum(terms_[i], rest);
      rest = partial.high;
      if (partial.low != 0) terms_[top++] = partial.low;
    }
    terms_[top++] = rest;
    terms_.resize(top);
    return std::move(*this);
  }

  boost::container::small_vector<double, 16> terms_;
};

}  // namespace leonhard::kernel
