// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "leonhard/kernel/point.hpp"

namespace leonhard {

/// A boundary or vertex marker as in Triangle's files; 0 is "none".
using Marker = std::int32_t;

/// A planar straight-line graph: what a mesh is made from.
///
/// Indices into points are 0-based whatever the file's numbering was.
struct Pslg {
  struct Segment {
    std::size_t from{}, to{};
    Marker marker{};
    friend bool operator==(const Segment&, const Segment&) = default;
  };
  /// Triangles reached from the seed without crossing a segment get this attribute and this largest area.
  struct Region {
    Point2 seed{};
    double attribute{};
    double max_area = -1;  ///< negative: no bound
    friend bool operator==(const Region&, const Region&) = default;
  };

  std::vector<Point2> points{};
  std::vector<Marker> point_markers{};  ///< one a point, or empty
  std::vector<Segment> segments{};
  std::vector<Point2> holes{};  ///< one seed point a hole
  std::vector<Region> regions{};
  std::map<Marker, std::string> marker_names{};  ///< e.g. 2 -> "farfield"; markers need no name
  std::string source{};                          ///< file or description, for messages

  friend bool operator==(const Pslg&, const Pslg&) = default;
};

}  // namespace leonhard
