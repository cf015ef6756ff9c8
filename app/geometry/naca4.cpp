// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/naca4.hpp"

#include <algorithm>
#include <cmath>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

/// The zero of NACA's thickness polynomial with c4 = 0.1015 beyond x = 1.
constexpr double sharp_zero = 1.0089304113651427;
constexpr int knot_count = 129;

}  // namespace

Naca4::Naca4(const std::string& digits, TrailingEdge trailing_edge, const std::string& where)
    : trailing_edge_(trailing_edge) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (digits.size() != 4 || !std::ranges::all_of(digits, is_digit))
    throw InputError(where, "\"" + digits + "\" is not a NACA four-digit section",
                     "give four digits such as \"0012\"");
  const auto digit = [&digits](std::size_t i) { return static_cast<double>(digits[i] - '0'); };
  camber_ = digit(0) / 100;
  camber_at_ = digit(1) / 10;
  thickness_ = (10 * digit(2) + digit(3)) / 100;
  if (thickness_ == 0)
    throw InputError(where, "NACA " + digits + " has no thickness",
                     "give a thickness in the last two digits");
  if ((camber_ == 0) != (camber_at_ == 0))
    throw InputError(where, "NACA " + digits + " has a camber without a place or a place without a camber",
                     "the first two digits are both zero or neither");
}

double Naca4::half_thickness(double x) const {
  if (trailing_edge_ != TrailingEdge::open && x >= 1) return 0;
  const double stretch = trailing_edge_ == TrailingEdge::sharp ? sharp_zero : 1;
  const double c4 = trailing_edge_ == TrailingEdge::closed ? 0.1036 : 0.1015;
  x *= stretch;
  return 5 * thickness_ / stretch *
         (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - c4 * x))));
}

Point2 Naca4::at(double s) const {
  const double x = s * s;
  const double offset = s >= 0 ? half_thickness(x) : -half_thickness(x);
  if (camber_ == 0) return {x, offset};
  const double p = camber_at_;
  const bool front = x < p;
  const double factor = camber_ / (front ? p * p : (1 - p) * (1 - p));
  const double height = factor * ((front ? 0 : 1 - 2 * p) + 2 * p * x - x * x);
  const double slope = factor * 2 * (p - x);
  const double c = 1 / std::hypot(1.0, slope);
  return {x - offset * slope * c, height + offset * c};
}

OutlineCurve Naca4::outline() const {
  CurvePiece surface;
  for (int i = 0; i < knot_count; ++i) surface.knots.push_back(2.0 * i / (knot_count - 1));
  surface.at = [section = *this](double t) { return section.at(1 - t); };
  const Point2 upper = at(1), lower = at(-1);
  OutlineCurve curve;
  curve.pieces.push_back(surface);
  curve.leading_edge = {0, 0};
  curve.trailing_edge = upper + 0.5 * (lower - upper);
  if (trailing_edge_ == TrailingEdge::open)
    curve.pieces.push_back(
        {[upper, lower](double t) { return t >= 1 ? upper : lower + t * (upper - lower); }, {0, 1}});
  return curve;
}

}  // namespace leonhard::app
