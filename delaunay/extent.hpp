// SPDX-License-Identifier: MIT
#pragma once

namespace leonhard::delaunay {

/// What a set of points of the plane or of space spans.
enum class Extent {
  nothing,  ///< there is no point
  point,    ///< one place
  line,     ///< two or more places, all on one line
  plane,    ///< three or more places, all in one plane, not all on one line: there are triangles
  space,    ///< four places are the corners of a tetrahedron; never in the plane
};

}  // namespace leonhard::delaunay
