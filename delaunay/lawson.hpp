// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string_view>

#include "leonhard/delaunay/plane/swap_criterion.hpp"
#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/progress.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// Triangulations by swapping edges: Lawson, "Software for C1 surface interpolation", in Mathematical
/// Software III (1977); Barth's notes 3.3d, and the end of 3.3b for criteria other than the Delaunay one.
namespace leonhard::delaunay {

enum class SwapOutcome {
  settled,     ///< no swap improves the triangulation any more
  swap_limit,  ///< as many swaps as were allowed have been made: a valid triangulation, not yet a settled one
  stopped,     ///< a stop was requested: likewise
};

/// The word for it, e.g. "settled".
[[nodiscard]] constexpr std::string_view to_string(SwapOutcome outcome) {
  switch (outcome) {
    case SwapOutcome::settled:
      return "settled";
    case SwapOutcome::swap_limit:
      return "swap_limit";
    case SwapOutcome::stopped:
      return "stopped";
  }
  return "";
}

struct [[nodiscard]] SwapReport {
  SwapOutcome outcome = SwapOutcome::settled;
  std::size_t swaps = 0;
};

struct SwapOptions {
  std::size_t max_swaps = std::numeric_limits<std::size_t>::max();
  Progress progress{};  ///< every 4096 edges; fraction: edges looked at, of these and the suspects left
  /// Edges that may not be swapped, by one of their sides. Empty: none.
  std::function<bool(const GhostTriangulation&, SideId)> is_fixed{};
};

/// Swap edges of any triangulation until the criterion is content.
///
/// points  one a vertex; every real triangle is counter-clockwise
/// Cost for the Delaunay criterion O(n^2) swaps at worst, often near O(n) from a good start; there is no such
/// bound for the others, but an end (swap_criterion.hpp).
SwapReport swap_edges(GhostTriangulation& in, std::span<const Point2> points, const SwapCriterion& criterion,
                      const SwapOptions& options = {});

/// The same for a mesh: boundary and constraints stay, and edges between triangles of different regions.
/// Triangles keep their numbers, boundary edges and all else their order.
///
/// mesh    mesh::validate finds nothing wrong with it
/// throws  InputError as mesh::build_edges does, mesh unchanged
SwapReport swap_edges(TriangleMesh& mesh, const SwapCriterion& criterion, const SwapOptions& options = {});

/// A triangulation by a sweep, with no regard for angles: points from left to right, each joined to all that
/// it sees of the hull before it. Lawson's start.
///
/// points  distinct and finite, in any order
/// Cost O(n log n).
[[nodiscard]] PointTriangulation triangulate_by_sweep(std::span<const Point2> points,
                                                      const AlgorithmOptions& options = {});

/// The Delaunay triangulation of distinct points by global edge swapping (Barth's notes 3.3d):
/// triangulate_by_sweep, with edges swapped by the Delaunay criterion as soon as they arise.
///
/// points  distinct and finite, in any order
/// Cost O(n^2) at worst, for points on two parallel lines for example; nearly O(n log n) for points at
/// random.
[[nodiscard]] PointTriangulation triangulate_lawson(std::span<const Point2> points,
                                                    const AlgorithmOptions& options = {});

/// A triangulation of distinct points that no swap improves by the criterion, one point after another: each
/// is joined to the corners about it, then edges are swapped, those at the new point and those found good
/// before included (Barth's notes, end of 3.3b). With the Delaunay criterion this is the Delaunay
/// triangulation; with others the result depends on the order of the points, which is that of their numbers
/// in rounds (insertion_order.hpp).
///
/// points     distinct and finite, best along a space-filling curve
/// criterion  its values, if it has any, are one a point
/// Cost as for swap_edges, and a walk to each point from the one before.
[[nodiscard]] PointTriangulation triangulate_by_criterion(std::span<const Point2> points,
                                                          const SwapCriterion& criterion,
                                                          const AlgorithmOptions& options = {});

}  // namespace leonhard::delaunay
