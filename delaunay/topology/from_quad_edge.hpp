// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/mesh/quad_edge.hpp"

namespace leonhard::delaunay {

/// The triangles of a quad-edge structure as a triangulation of the sphere: triangle f is face f, and ghost
/// triangles behind the edges that have no face on one side come after the last. Vertices keep their numbers.
///
/// quads  every edge has a vertex at both ends and a face on one side at least; faces are numbered without
///        gaps and have three edges each (validate() of the result finds the rest)
/// Cost O(edges).
[[nodiscard]] GhostTriangulation ghost_triangulation(const QuadEdge& quads);

}  // namespace leonhard::delaunay
