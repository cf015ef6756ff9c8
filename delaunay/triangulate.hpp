// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/delaunay/algorithm.hpp"
#include "leonhard/delaunay/crossings.hpp"
#include "leonhard/delaunay/input_segments.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::delaunay {

struct TriangulateOptions {
  /// Keep the whole convex hull. Otherwise, where there are segments, all that can be reached from outside
  /// without crossing a segment is carved away. Holes are carved in both cases.
  bool keep_convex_hull = false;
  Progress progress{};
  Algorithm algorithm = Algorithm::fast;  ///< the mesh does not depend on it
  unsigned threads = 1;                   ///< 0: as many as there are cores; the mesh does not depend on it
  std::uint64_t seed = 1;                 ///< of randomised algorithms; the mesh does not depend on it
  Crossings crossings = Crossings::reject;
};

struct [[nodiscard]] Triangulation {
  TriangulateOutcome outcome = TriangulateOutcome::done;
  TriangleMesh mesh;
  /// One an input point: its vertex. Duplicates share one; none where the point lies in a hole or outside.
  std::vector<MaybeId<VertexId>> vertex_of_input;
  /// Of each boundary and constraint edge the input segment that it is a part of, exactly.
  InputSegments segments;
  std::vector<Crossing> crossings{};  ///< that became points (Crossings::split), by input segments
  /// What was mended, in words: merged points, overlapping segments, seeds without effect. Empty: nothing.
  std::vector<std::string> repairs;
};

/// The constrained Delaunay triangulation of a planar straight-line graph; no point is added but those of crossings
/// (Crossings::split), whose vertices come after the input's.
///
/// Without segments it is the Delaunay triangulation of the points, convex hull included. It depends on the
/// coordinates alone: cocircular ties are broken by kernel::incircle_perturbed, so any order of the input
/// gives the same set of triangles. Equal points are merged (the first one's marker stays unless it is 0). A
/// vertex on a segment splits it; overlapping segments are merged (the first one's marker stays unless it is
/// 0).
///
/// Vertices are numbered in the order of the input points that made them. Boundary edges carry their
/// segment's marker, 0 included, or 1 where there is no segment. mesh.constraints holds the interior edges that
/// came from segments, marker kept. Vertex markers are kept as they were.
///
/// throws  InputError: a coordinate that is not finite; a segment's end that is no point; segments that cross
///         other than at a shared point, unless options.crossings says otherwise; a seed exactly on a segment; segments that enclose nothing although
///         concavities are to be carved.
/// Cost O(n log n) expected for points in any order, plus the edges that each segment crosses.
Triangulation triangulate(Pslg pslg, const TriangulateOptions& options = {});

/// The Delaunay triangulation of points alone.
Triangulation triangulate(std::vector<Point2> points, const TriangulateOptions& options = {});

}  // namespace leonhard::delaunay
