// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/point_set.hpp"

namespace leonhard {

/// A surface as its file states it: corners exist and coordinates are finite; nothing else is known to be right.
struct SurfaceFile {
  PointSet3 set;                        ///< the vertices, those of no polygon included
  std::vector<std::size_t> offsets{0};  ///< polygon i has the corners offsets[i] to offsets[i + 1] - 1
  std::vector<VertexId> corners;        ///< of all polygons
  std::vector<Marker> markers;          ///< one a polygon, or empty
  std::vector<std::size_t> facets;      ///< TetGen's: polygons of one number bound one flat facet; or empty
  std::vector<std::string> warnings;

  [[nodiscard]] std::size_t polygon_count() const { return offsets.size() - 1; }
  [[nodiscard]] std::span<const VertexId> polygon(std::size_t i) const {
    return std::span(corners).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
};

}  // namespace leonhard
