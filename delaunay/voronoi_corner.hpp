// SPDX-License-Identifier: MIT
#pragma once

namespace leonhard::delaunay {

/// A corner of a Voronoi cell: the centre of an empty circle or sphere through vertices.
template <class Point>
struct VoronoiCorner {
  Point at;
  /// At most this far from the exact centre (kernel/constructions.hpp). Infinite where that lies beyond the largest double:
  /// `at` is then a point at the end of the doubles' range, in about its direction.
  double error{};
};

}  // namespace leonhard::delaunay
