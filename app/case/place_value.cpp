// SPDX-License-Identifier: MIT
#include "leonhard/app/case/place_value.hpp"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace leonhard::app {
namespace {

/// A parser and the numbers that its variables are.
struct Formula {
  double x = 0, y = 0, z = 0;
  mu::Parser parser;
};

/// "Unexpected token "q" found at position 6." without the place and the dot: the place is told otherwise.
std::string without_place(std::string words) {
  if (const std::size_t place = words.find(" found at position"); place != std::string::npos) words.resize(place);
  if (const std::size_t place = words.find(" at position"); place != std::string::npos) words.resize(place);
  while (!words.empty() && words.back() == '.') words.pop_back();
  return words;
}

}  // namespace

PlaceValue::Function parse_formula(const std::string& text) {
  const auto formula = std::make_shared<Formula>();
  try {
    formula->parser.DefineVar("x", &formula->x);
    formula->parser.DefineVar("y", &formula->y);
    formula->parser.DefineVar("z", &formula->z);
    formula->parser.DefineConst("pi", std::numbers::pi);
    formula->parser.DefineConst("e", std::numbers::e);
    formula->parser.SetExpr(text);
    int values = 0;
    formula->parser.Eval(values);  // the text is only read now
    if (values != 1) throw FormulaError("it has " + std::to_string(values) + " values", 0);
  } catch (const mu::Parser::exception_type& error) {
    const bool placed = error.GetPos() >= 0 && static_cast<std::size_t>(error.GetPos()) <= text.size();
    throw FormulaError(without_place(error.GetMsg()), placed ? static_cast<std::size_t>(error.GetPos()) + 1 : 0);
  }
  return [formula](const Point3& at) {
    formula->x = at.x, formula->y = at.y, formula->z = at.z;
    return formula->parser.Eval();
  };
}

PlaceValue::Function interpolate(PlaceValue::Function along, std::vector<double> at, std::vector<double> values) {
  return [along = std::move(along), at = std::move(at), values = std::move(values)](const Point3& place) {
    const double t = along(place);
    const auto after = std::ranges::upper_bound(at, t);
    if (after == at.begin()) return values.front();
    if (after == at.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - at.begin());
    return std::lerp(values[i - 1], values[i], (t - at[i - 1]) / (at[i] - at[i - 1]));
  };
}

}  // namespace leonhard::app
