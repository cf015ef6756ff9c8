// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace leonhard::delaunay {

/// What a set of points of the plane or of space spans.
enum class Extent {
  nothing,  ///< there is no point
  point,    ///< one place
  line,     ///< two or more places, all on one line
  plane,    ///< three or more places, all in one plane, not all on one line: there are triangles
  space,    ///< four places are the corners of a tetrahedron; never in the plane
};

/// The word for it, e.g. "nothing".
[[nodiscard]] constexpr std::string_view to_string(Extent extent) {
  switch (extent) {
    case Extent::nothing:
      return "nothing";
    case Extent::point:
      return "point";
    case Extent::line:
      return "line";
    case Extent::plane:
      return "plane";
    case Extent::space:
      return "space";
  }
  return "";
}

}  // namespace leonhard::delaunay
