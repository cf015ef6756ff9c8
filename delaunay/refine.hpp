// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "leonhard/delaunay/crossings.hpp"
#include "leonhard/delaunay/input_segments.hpp"
#include "leonhard/delaunay/refine_options.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::delaunay {

struct [[nodiscard]] RefinedMesh {
  TriangleMesh mesh;
  RefineReport report;
  std::vector<MaybeId<VertexId>> vertex_of_input;  ///< as in Triangulation; all input vertices come first
  /// As in Triangulation. A split point that is no pair of doubles is rounded, and its edges are beside their segment then:
  /// exactly on it where report.rounded_splits is 0.
  InputSegments segments;
  std::vector<Crossing> crossings;  ///< that became points (Crossings::split), by input segments
};

/// A quality mesh of the domain that a planar straight-line graph bounds: constrained Delaunay triangulation,
/// holes and concavities carved, then Delaunay refinement.
///
/// Method: Ruppert, J. Algorithms 18 (1995); split points are the off-centres of Üngör, LATIN 2004; a segment
/// is encroached when a vertex that sees it lies in its diametral lens (Shewchuk, Comput. Geom. 22, 2002);
/// segments at small input angles are split on concentric power-of-two shells and triangles between equal
/// shells are left alone (Miller, Pav and Walkington, 2003), so that the work ends for every input. The
/// result is again constrained Delaunay and depends on the coordinates alone, not on their order. Markers are those
/// that triangulate gives; a vertex added on a segment takes its marker.
///
/// throws  InputError: as triangulate; options out of range; fewer than three points or all on one line;
///         coordinates so large or small that their squares leave the range of double; options.size returning
///         a number that is not positive and finite.
RefinedMesh mesh_pslg(const Pslg& pslg, const RefineOptions& options);

}  // namespace leonhard::delaunay
