// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard::app {

/// A number of a case file that may depend on the place; in the plane z is 0.
class PlaceValue {
 public:
  using Function = std::function<double(const Point3&)>;

  PlaceValue(double constant) : constant_(constant) {}  // NOLINT(google-explicit-constructor): a number is a value everywhere
  /// of    what it throws passes through
  /// text  as the case file has it
  PlaceValue(Function of, std::string text) : of_(std::move(of)), text_(std::move(text)) {}

  [[nodiscard]] double operator()(const Point3& at) const { return of_ ? of_(at) : constant_; }
  [[nodiscard]] bool varies() const { return static_cast<bool>(of_); }
  /// The number where it does not vary.
  [[nodiscard]] double constant() const { return constant_; }

  friend bool operator==(const PlaceValue& a, const PlaceValue& b) {
    return a.varies() == b.varies() && a.text_ == b.text_ && (a.varies() || a.constant_ == b.constant_);
  }

 private:
  double constant_ = 0;
  Function of_;
  std::string text_;
};

/// What is wrong with a formula.
struct FormulaError : std::runtime_error {
  FormulaError(const std::string& words, std::size_t in_column) : std::runtime_error(words), column(in_column) {}
  std::size_t column;  ///< from 1; 0 where no single place is wrong
};

/// A formula of x, y and z, and of the constants pi and e: + - * / ^, comparisons, a ? b : c, and the functions of muparser (sin, sqrt,
/// exp, ln, abs, min, max, tanh, atan2 ...). Calls from several threads at once are not safe.
/// throws  FormulaError for what is no formula of one value
[[nodiscard]] PlaceValue::Function parse_formula(const std::string& text);

/// Straight lines between the points of a table, constant before the first and after the last one.
///
/// along   the coordinate that the table is ordered by
/// at      ascending, as many as values, at least one
[[nodiscard]] PlaceValue::Function interpolate(PlaceValue::Function along, std::vector<double> at, std::vector<double> values);

}  // namespace leonhard::app
