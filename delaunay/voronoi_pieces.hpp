// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "leonhard/delaunay/voronoi_clip.hpp"

namespace leonhard::delaunay {

/// The cells of a Voronoi diagram cut to a polygon: of a site none, one or several simple polygons, which need not be convex.
struct VoronoiPieces {
  std::vector<VertexId> site;                ///< one a piece, rising
  std::vector<std::size_t> first_corner{0};  ///< one a piece and one more
  std::vector<Point2> corners;               ///< piece by piece, counter-clockwise
  std::vector<double> area;                  ///< one a piece; square units of the coordinates

  [[nodiscard]] std::size_t size() const { return site.size(); }
  [[nodiscard]] std::span<const Point2> piece(std::size_t i) const {
    return std::span(corners).subspan(first_corner[i], first_corner[i + 1] - first_corner[i]);
  }
  void add(VertexId of_site, std::span<const Point2> polygon, double its_area);
};

/// The cells of a window that are not empty, a piece each.
[[nodiscard]] VoronoiPieces pieces_of(const ClippedVoronoi& cells);

/// Cut the cells to a simple polygon, convex or not. The areas add up to the polygon's, to rounding of the coordinates.
///
/// The polygon's Delaunay triangulation, which is exact, gives convex windows for `clip`; what a site has in neighbouring triangles
/// is joined where both have the same edge to the last bit, as they do but for slivers at the rounding of a vertex near it. Points
/// at which sides of cells cross the triangulation's diagonals stay corners, the same ones of both cells.
///
/// polygon  its corners in order, either way round, each once
/// throws   InputError for a polygon that is not finite, crosses or touches itself, or has fewer than three corners
/// Cost O(corners of the polygon · edges · log edges).
[[nodiscard]] VoronoiPieces clip_to_polygon(const VoronoiDiagram& diagram, std::span<const Point2> polygon);

}  // namespace leonhard::delaunay
