// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/delaunay/constrained/constrained_triangulation.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::delaunay {

/// The triangulation without its holes and, unless the hull is kept, without all that can be reached from outside
/// without crossing a segment. Every boundary edge is a piece afterwards, has a ghost triangle behind it, and a
/// marker that is not 0 (1 where the segment had none). Regions are assigned if pslg has any.
///
/// in       constrained Delaunay of a convex domain
/// repairs  notes on seeds without effect are appended
/// throws   InputError: a seed exactly on a segment; nothing left
/// Cost O(triangles + seeds * sqrt(triangles)).
[[nodiscard]] ConstrainedTriangulation carve(const ConstrainedTriangulation& in, const Pslg& pslg,
                                             bool keep_convex_hull, std::vector<std::string>& repairs);

}  // namespace leonhard::delaunay
