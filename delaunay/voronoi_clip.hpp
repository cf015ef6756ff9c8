// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "leonhard/delaunay/voronoi.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The cells of a Voronoi diagram cut to a convex window: one convex polygon a site.
struct ClippedVoronoi {
  std::vector<std::size_t> first_corner;  ///< one a site and one more
  std::vector<Point2> corners;   ///< cell by cell, counter-clockwise; a cell outside the window has none
  PerId<VertexId, double> area;  ///< square units of the coordinates; infinite beyond the largest double

  /// throws  InputError if there is no such site
  [[nodiscard]] std::span<const Point2> cell(VertexId site) const {
    if (!area.contains(site)) [[unlikely]]
      throw InputError("site " + std::to_string(site.raw), "is none of " + std::to_string(area.size()));
    return std::span(corners).subspan(first_corner[site.index()],
                                      first_corner[site.index() + 1] - first_corner[site.index()]);
  }
};

/// Cut the cells to a window. The areas add up to the window's, to rounding of the coordinates.
///
/// A cell is cut out of the window by the bisectors between its site and its neighbours (Sutherland and Hodgman, CACM 17 (1974)
/// 32-42), in coordinates about the site scaled by a power of two: neither far circumcentres nor huge coordinates spoil it, errors
/// are some units in the last place of the window's size, and cells of sites with small whole coordinates are exact. The area is
/// that of this polygon, so it keeps its digits far from the origin. The corners are those that both cells at a side have: the
/// diagram's vertices, and crossings of its edges with the window's sides, which are found once; so neighbours share their
/// corners to the last bit.
///
/// window  corners of a convex polygon, counter-clockwise; three or more, not all on one line
/// throws  InputError for a window that is not finite, not convex or not counter-clockwise
/// Cost O(edges x corners of the window), and for a cell that is not within it O(edges x corners it is left with).
[[nodiscard]] ClippedVoronoi clip(const VoronoiDiagram& diagram, std::span<const Point2> window);

/// The corners of a box, as a window. throws InputError unless low < high in both directions
[[nodiscard]] std::array<Point2, 4> box_window(Point2 low, Point2 high);

/// A window that shows a set of points: their bounding box, and about it a margin of the share `margin` of its longer
/// side (of 1 where the points are all one).
[[nodiscard]] std::array<Point2, 4> window_about(std::span<const Point2> points, double margin = 0.1);

}  // namespace leonhard::delaunay
