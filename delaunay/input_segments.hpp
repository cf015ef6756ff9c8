// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// An index into Pslg::segments.
using SegmentId = Id<struct SegmentTag>;

/// The input segment that each marked edge of a mesh is a part of, which is more than its marker says: segments may share
/// a marker or have none.
///
/// An edge runs the same way as its segment or the other way. Ordered along the segment, all edges of one segment lead
/// from its first point to its last, but for what was carved away. Where segments overlap, the piece that they share is
/// one edge and belongs to the first of them in the input's order (the repairs name such pairs); its marker is the first
/// of theirs that is not 0.
struct InputSegments {
  std::vector<MaybeId<SegmentId>>
      boundary;  ///< one an entry of the mesh's boundary; none: an edge of the convex hull without a segment
  std::vector<MaybeId<SegmentId>> constraints;  ///< one an entry of the mesh's constraints, none missing
};

}  // namespace leonhard::delaunay
