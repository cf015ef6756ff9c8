// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "leonhard/kernel/point.hpp"

namespace leonhard::app {

/// A grid whose step is a power of two: 2^-36 of the size of the bodies, coarser only if the coordinates are so large that
/// less than six bits of a double's 53 were left.
///
/// With coordinates on the grid, the middle of a segment is the exact half of the sum, as long as spare bits last (at
/// least six, usually ten: a segment may be halved that many times over). So a mesher that splits at such points changes no
/// boundary by rounding, and the mesh's area is the polygon's, in exact rational arithmetic.
class DyadicGrid {
 public:
  /// size     of the bodies, > 0: what accuracy refers to
  /// largest  absolute value of any coordinate
  DyadicGrid(double size, double largest)
      : step_(std::ldexp(1.0, std::max(std::ilogb(size) - 36, std::ilogb(std::max(size, largest)) - 46))) {}

  [[nodiscard]] double step() const { return step_; }
  /// The nearest multiple of the step; exact, as the quotient and the product by a power of two are.
  [[nodiscard]] double operator()(double x) const { return std::nearbyint(x / step_) * step_ + 0.0; }
  [[nodiscard]] Point2 operator()(Point2 p) const { return {(*this)(p.x), (*this)(p.y)}; }

 private:
  double step_;
};

}  // namespace leonhard::app
