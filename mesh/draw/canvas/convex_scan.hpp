// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "leonhard/kernel/point.hpp"

namespace leonhard::draw {

/// Calls paint(row, first, last) for the samples first <= i < last of each row whose centres, (i + 0.5, row + 0.5), lie
/// in a convex polygon. Of polygons that share an edge exactly one gets a sample on it: crossings are computed from ends
/// in order of coordinates, with the same bits from either side.
template <class Paint>
void scan_convex(std::span<const Point2> corners, std::int64_t rows, std::int64_t columns, Paint paint) {
  double low = corners[0].y, high = low;
  for (const Point2 p : corners) low = std::min(low, p.y), high = std::max(high, p.y);
  const auto bound = [](double v, std::int64_t most) {
    return static_cast<std::int64_t>(std::ceil(std::clamp(v, 0.0, static_cast<double>(most))));
  };
  const std::int64_t last_row = bound(high - 0.5, rows);
  for (std::int64_t row = bound(low - 0.5, rows); row < last_row; ++row) {
    const double y = static_cast<double>(row) + 0.5;
    double left = 0, right = 0;
    int found = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Point2 a = corners[i], b = corners[i + 1 < corners.size() ? i + 1 : 0];
      if ((a.y <= y) == (b.y <= y)) continue;
      if (b.y < a.y) std::swap(a, b);
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      left = found == 0 ? x : std::min(left, x);
      right = found == 0 ? x : std::max(right, x);
      ++found;
    }
    if (found < 2) continue;
    const std::int64_t first = bound(left - 0.5, columns), last = bound(right - 0.5, columns);
    if (first < last) paint(row, first, last);
  }
}

}  // namespace leonhard::draw
