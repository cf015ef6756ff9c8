// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard {

/// Points of the plane with what their file says of them.
struct PointSet {
  std::vector<Point2> points;
  std::vector<Marker> markers;  ///< one a point, or empty
  std::size_t attributes_each = 0;
  std::vector<double> attributes;  ///< attributes_each a point, point after point

  friend bool operator==(const PointSet&, const PointSet&) = default;
};

}  // namespace leonhard
