// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "leonhard/delaunay/algorithm.hpp"
#include "leonhard/delaunay/constrained/arrange.hpp"
#include "leonhard/delaunay/constrained/constrained_triangulation.hpp"
#include "leonhard/delaunay/order/sorted_points.hpp"
#include "leonhard/kernel/progress.hpp"
#include "leonhard/mesh/pslg.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::delaunay {

/// A planar straight-line graph on its way to a mesh: sorted, triangulated, constrained, carved.
struct Domain {
  TriangulateOutcome outcome = TriangulateOutcome::done;
  SortedPoints sorted;             ///< vertex i of the triangulation is its point i; the points moved on
  ConstrainedTriangulation cells;  ///< carved; every boundary edge is a piece. Empty unless done
  std::optional<Arrangement> arrangement;  ///< where segments crossed: the graph that was triangulated
  std::vector<std::string> repairs;
};

/// throws  InputError: the first of the faults that triangulate lists which can be seen without triangulating
void check(const Pslg& pslg);

/// Say in words how many points were merged and how many segments had no length.
void note_duplicates(const Pslg& pslg, const SortedPoints& sorted, std::vector<std::string>& repairs);

/// The mesh's vertices take the markers of their points; of several at one place the first that is not 0.
void set_point_markers(const Pslg& pslg, const std::vector<MaybeId<VertexId>>& vertex_of_input,
                       TriangleMesh& mesh);

/// Steps 1 to 3 of triangulate and mesh_pslg: check, sort and merge, triangulate, constrain and carve.
///
/// keep_convex_hull  as in TriangulateOptions; a graph without segments keeps it too
/// throws            InputError, as listed at triangulate
/// Where segments cross, which shows when they are inserted, the work before is done twice.
[[nodiscard]] Domain make_domain(const Pslg& pslg, bool keep_convex_hull, Crossings crossings, Algorithm algorithm,
                                 const AlgorithmOptions& options);

/// The domain's cells as a mesh: input vertices first, in the order of the points that made them, then those
/// added since; points without a triangle are left out.
///
/// vertex_of_input  filled, one an input point
/// segments         filled, one a marked edge
[[nodiscard]] TriangleMesh to_mesh(const Domain& domain, const Pslg& pslg,
                                   std::vector<MaybeId<VertexId>>& vertex_of_input, InputSegments& segments);

}  // namespace leonhard::delaunay
