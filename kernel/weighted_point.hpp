// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"

namespace leonhard {

/// A point of a regular (weighted Delaunay) triangulation.
///
/// weight  the squared radius of the circle about the point, any finite number; negative: an imaginary circle
struct WeightedPoint2 {
  Point2 point;
  double weight{};

  friend constexpr bool operator==(const WeightedPoint2&, const WeightedPoint2&) = default;
};

/// As WeightedPoint2, in space: the weight is the squared radius of a sphere.
struct WeightedPoint3 {
  Point3 point;
  double weight{};

  friend constexpr bool operator==(const WeightedPoint3&, const WeightedPoint3&) = default;
};

}  // namespace leonhard
