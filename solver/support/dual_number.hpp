// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "leonhard/solver/support/lanes.hpp"

namespace leonhard::solver {

/// A number and its derivatives by n variables (forward automatic differentiation): what a formula written for any number
/// type gives for this one is its value and its exact derivatives. Where it chooses (select, larger), the derivative is
/// that of the choice.
template <int n>
struct DualNumber {
  double value{};
  double by[n]{};

  DualNumber() = default;
  DualNumber(double v) : value(v) {}  // NOLINT(google-explicit-constructor): a constant is a number without derivatives

  /// The variable of number i.
  static DualNumber variable(double v, int i) {
    DualNumber x(v);
    x.by[i] = 1;
    return x;
  }

  friend DualNumber operator+(const DualNumber& a, const DualNumber& b) {
    DualNumber c(a.value + b.value);
    for (int i = 0; i < n; ++i) c.by[i] = a.by[i] + b.by[i];
    return c;
  }
  friend DualNumber operator-(const DualNumber& a, const DualNumber& b) {
    DualNumber c(a.value - b.value);
    for (int i = 0; i < n; ++i) c.by[i] = a.by[i] - b.by[i];
    return c;
  }
  friend DualNumber operator-(const DualNumber& a) { return DualNumber(0.0) - a; }
  friend DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    DualNumber c(a.value * b.value);
    for (int i = 0; i < n; ++i) c.by[i] = a.value * b.by[i] + b.value * a.by[i];
    return c;
  }
  friend DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    DualNumber c(a.value / b.value);
    for (int i = 0; i < n; ++i) c.by[i] = (a.by[i] - c.value * b.by[i]) / b.value;
    return c;
  }
  DualNumber& operator+=(const DualNumber& b) { return *this = *this + b; }
  DualNumber& operator-=(const DualNumber& b) { return *this = *this - b; }
  DualNumber& operator*=(const DualNumber& b) { return *this = *this * b; }
  friend bool operator<(const DualNumber& a, const DualNumber& b) { return a.value < b.value; }
  friend bool operator>(const DualNumber& a, const DualNumber& b) { return a.value > b.value; }
};

template <int n>
[[nodiscard]] DualNumber<n> select(bool mask, const DualNumber<n>& yes, const DualNumber<n>& no) {
  return mask ? yes : no;
}

template <int n>
[[nodiscard]] DualNumber<n> root(const DualNumber<n>& x) {
  DualNumber<n> y(std::sqrt(x.value));
  for (int i = 0; i < n; ++i) y.by[i] = 0.5 * x.by[i] / y.value;
  return y;
}

[[nodiscard]] inline double power(double x, double exponent) { return std::pow(x, exponent); }
template <int n>
[[nodiscard]] DualNumber<n> power(const DualNumber<n>& x, double exponent) {
  DualNumber<n> y(std::pow(x.value, exponent));
  for (int i = 0; i < n; ++i) y.by[i] = exponent * y.value / x.value * x.by[i];
  return y;
}

}  // namespace leonhard::solver
