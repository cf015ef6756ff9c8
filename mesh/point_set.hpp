// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard {

/// Points with what their file says of them.
template <class Point>
struct PointSetOf {
  std::vector<Point> points{};
  std::vector<Marker> markers{};  ///< one a point, or empty
  std::size_t attributes_each = 0;
  std::vector<double> attributes{};  ///< attributes_each a point, point after point

  friend bool operator==(const PointSetOf&, const PointSetOf&) = default;
};

using PointSet = PointSetOf<Point2>;   ///< of the plane
using PointSet3 = PointSetOf<Point3>;  ///< of space

}  // namespace leonhard
