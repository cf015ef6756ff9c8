// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "leonhard/kernel/point.hpp"

/// The range of coordinates in which the expansions of a predicate are exact.
namespace leonhard::kernel {

/// Binary exponents that coordinates other than 0 may have.
struct ExponentWindow {
  int lowest, highest;
};

/// The lowest bit of a coordinate of exponent e is at e - 52 or higher, that of a difference too, that of a
/// product of Degree differences at Degree (e - 52), which must be representable: at least -1074. A
/// difference is below 2^(e + 2), a sum of up to 72 products of them (insphere's) below 2^(Degree (e + 2) + 7),
/// and splitting multiplies by 2^28: the whole must stay below 2^1023.
template <int Degree>
inline constexpr ExponentWindow exact_window{52 - 1074 / Degree, (1023 - 28 - 7) / Degree - 2};
static_assert(exact_window<2>.lowest == -485 && exact_window<2>.highest == 492);
static_assert(exact_window<5>.lowest == -162 && exact_window<5>.highest == 195);

[[nodiscard]] inline std::array<double*, 2> coordinates(Point2& p) { return {&p.x, &p.y}; }
[[nodiscard]] inline std::array<double*, 3> coordinates(Point3& p) { return {&p.x, &p.y, &p.z}; }

/// Moves the points into the window by a power of two, which changes no sign of a homogeneous polynomial and
/// no bit of a coordinate.
///
/// returns  false, and leaves the points alone, if their exponents are too far apart
template <class Point, std::size_t Count>
[[nodiscard]] bool fit(std::array<Point, Count>& points, ExponentWindow window) {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (Point& p : points)
    for (const double* coordinate : coordinates(p)) {
      const double size = std::abs(*coordinate);
      largest = std::max(largest, size);
      if (size != 0) smallest = std::min(smallest, size);
    }
  if (largest == 0) return true;
  const int lowest = std::ilogb(smallest), highest = std::ilogb(largest);
  if (lowest >= window.lowest && highest <= window.highest) return true;
  if (highest - lowest > window.highest - window.lowest) return false;
  const int shift = window.highest - highest;
  for (Point& p : points)
    for (double* coordinate : coordinates(p)) *coordinate = std::scalbn(*coordinate, shift);
  return true;
}

}  // namespace leonhard::kernel
