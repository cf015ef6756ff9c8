// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/app/case/case.hpp"
#include "leonhard/app/geometry/curve.hpp"

namespace leonhard::app {

/// A NACA four-digit section of chord 1 as formulas.
///
/// Half thickness: 5 t (0.2969 sqrt x - 0.1260 x - 0.3516 x^2 + 0.2843 x^3 - c4 x^4), with
///   open    c4 = 0.1015, cut at x = 1: a blunt trailing edge 0.0252 t/0.12 % of the chord thick (NACA's
///   own); closed  c4 = 0.1036, which makes it vanish at x = 1; sharp   c4 = 0.1015 prolonged to its zero x
///   = 1.00893..., the thickness scaled back to chord 1.
/// The thickness is laid off at right angles to the mean line m (2 p x - x^2) / p^2 ...
/// Source: Jacobs, Ward and Pinkerton, NACA report 460 (1933); the sharp form: Vassberg and Jameson, AIAA
/// 2009-4143.
class Naca4 {
 public:
  /// digits  "2412": camber 2 %, at 40 % of the chord, thickness 12 %
  /// throws  InputError(where) unless they are four digits with thickness > 0 and camber and its place both
  /// or
  ///         neither zero
  Naca4(const std::string& digits, TrailingEdge, const std::string& where);

  /// The point of the surface at the signed root of the chord fraction: s = 1 is the upper trailing edge,
  /// s = 0 the leading edge, s = -1 the lower trailing edge; x on the mean line is s^2.
  [[nodiscard]] Point2 at(double s) const;

  /// Half the thickness at chord fraction x in [0, 1].
  [[nodiscard]] double half_thickness(double x) const;

  /// The whole outline, counter-clockwise from the upper trailing edge.
  [[nodiscard]] OutlineCurve outline() const;

 private:
  double camber_ = 0, camber_at_ = 0, thickness_ = 0;
  TrailingEdge trailing_edge_;
};

}  // namespace leonhard::app
