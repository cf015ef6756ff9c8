// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The Delaunay triangulation of some consecutive points, inside the triangulation of more. n points have 2 n - 2
/// triangles, ghosts included (collinear ones have ghosts alone, a single one has none), numbered from
/// 2 first on: so the parts of one triangulation can be made at the same time, and each triangle's number depends on
/// the cuts alone.
struct Part {
  std::uint32_t first{}, last{};  ///< points first, ..., last - 1
  AnyTriangleId hull{};           ///< one of its ghost triangles, if it has any

  [[nodiscard]] std::uint32_t point_count() const { return last - first; }
  [[nodiscard]] static Part single(std::uint32_t point) { return {point, point + 1, {}}; }
};

/// How two parts are separated: the points of the lower part are less than those of the upper one, compared by (x, y)
/// or by (y, -x).
enum class Cut { by_x, by_y };

/// Join two neighbouring parts into one by a bubble that rises between them.
///
/// in      has triangles for all points; those of the two parts, and two more between them, are written
/// points  distinct; lower.last == upper.first
/// Cost O(edges made and removed, and vertices of the two hulls).
/// Method: Guibas and Stolfi 1985 (Barth's notes 3.3a), on triangles with ghosts (Shewchuk 1996): a candidate's edge
/// is removed by flipping it with its ghost, and the ghost of the edge chosen becomes the new triangle.
Part merge(std::span<const Point2> points, GhostTriangulation& in, const Part& lower, const Part& upper,
           Cut cut);

}  // namespace leonhard::delaunay
