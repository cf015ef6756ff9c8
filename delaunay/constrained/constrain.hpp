// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "leonhard/delaunay/constrained/constrained_triangulation.hpp"
#include "leonhard/kernel/progress.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::delaunay {

/// Overlaps met while segments were inserted.
struct OverlapNote {
  std::size_t segment, earlier;  ///< input segments that share a piece; the earlier one keeps it
};

struct InsertedSegments {
  std::vector<OverlapNote> overlaps;  ///< in the order met
  bool some_cross = false;            ///< then no more were inserted
};

/// Force the segments into a Delaunay triangulation of all their ends and make it constrained Delaunay again.
///
/// in         unconstrained Delaunay
/// pslg       for segments
/// vertex_of  one an input point: its vertex
/// returns    what was met; if two segments cross other than at a vertex, or a stop was requested, segments are missing
///            (the triangulation is valid)
/// A vertex on a segment splits it. Segments whose ends are one point are left out.
/// Cost: the edges each segment crosses, typically linear, at worst squared.
/// Method: crossed edges are flipped until none crosses (Sloan, Computers & Structures 47, 1993), then Lawson's flips
/// restore the constrained Delaunay property (Lee and Lin 1986); ties by incircle_perturbed make it unique.
InsertedSegments insert_segments(ConstrainedTriangulation& in, const Pslg& pslg, const std::vector<VertexId>& vertex_of,
                                 const Progress& progress);

}  // namespace leonhard::delaunay
