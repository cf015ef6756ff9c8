// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/mesh/io/points_file.hpp"

namespace leonhard::app {

/// Points, and what joins some of them, as files of shapes have them.
struct PlanarShapes {
  struct Line {
    std::size_t first, end;  ///< of the points, end excluded
    bool closed =
        false;  ///< a ring of a polygon: the last point is joined to the first, which does not come again
    bool hole = false;  ///< the ring bounds a hole of its polygon
  };

  PointsFile points;
  std::vector<Line> lines;
};

/// Well-known text (OGC 06-103r4, 7): POINT, LINESTRING, POLYGON, their MULTI forms and GEOMETRYCOLLECTION, one after another,
/// with Z, M and SRID=...; or without; heights are left out, which a warning tells.
///
/// source  names the text in errors
/// throws  InputError naming file and line: no such geometry, what is no number, brackets that do not match, no point at all
[[nodiscard]] PlanarShapes parse_wkt(std::string_view text, const std::string& source);

}  // namespace leonhard::app
