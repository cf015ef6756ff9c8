// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/canvas/axes.hpp"
#include "leonhard/mesh/draw/canvas/canvas.hpp"
#include "leonhard/mesh/draw/picture.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::draw {

/// throws InputError if the arrays do not fit together or there is no triangle
void check_mesh(const TriangleMesh& mesh);

/// The region a view asks for: its own, or the mesh's box. throws InputError for an empty or endless one
[[nodiscard]] Box region_of(const TriangleMesh& mesh, const View& view);

/// A frame with one scale for both directions that shows all of the region.
///
/// outer  page rectangle for frame, ticks, labels and title
[[nodiscard]] PlotFrame fit_map(Canvas& canvas, const Rect& outer, const Box& region, const AxesText& text);

/// A mesh laid out on a page: what the pictures of meshes share.
class MeshScene {
 public:
  MeshScene(const TriangleMesh& mesh, const PlotFrame& frame);

  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
  [[nodiscard]] const PlotFrame& frame() const { return frame_; }
  [[nodiscard]] Point2 page(VertexId v) const { return page_[v]; }
  [[nodiscard]] std::span<const Point2> page() const { return page_.flat(); }
  [[nodiscard]] std::array<Point2, 3> corners(TriangleId t) const;
  /// The triangles that touch the frame, rising.
  [[nodiscard]] std::span<const TriangleId> visible() const { return visible_; }
  [[nodiscard]] bool is_visible(TriangleId t) const { return is_visible_[t] != 0; }
  /// Too many triangles for vectors: beyond these an embedded image makes the smaller file (areas compress well,
  /// lines less so).
  [[nodiscard]] bool is_large_for_areas() const { return visible_.size() > 20'000; }
  [[nodiscard]] bool is_large_for_lines() const { return visible_.size() > 60'000; }
  /// The rectangle to which geometry is cut before it is drawn, somewhat beyond the frame.
  [[nodiscard]] Rect safe() const { return frame_.area.grown(100); }

 private:
  const TriangleMesh& mesh_;
  PlotFrame frame_;
  PerId<VertexId, Point2> page_;
  std::vector<TriangleId> visible_;
  PerId<TriangleId, char> is_visible_;
};

/// A convex or other simple polygon cut to a rectangle (Sutherland and Hodgman, CACM 17 (1974) 32-42); parts of a
/// concave one stay joined along the rectangle's sides.
[[nodiscard]] std::vector<Point2> cut_polygon(std::vector<Point2> polygon, const Rect& r);

/// Adds a polygon to the canvas' path; nothing if it has fewer than three corners.
void add_polygon(Canvas& canvas, std::span<const Point2> polygon);

/// The insides of bodies: light grey.
void fill_bodies(Canvas& canvas, const MeshScene& scene);

/// Each visible triangle in a colour; index_of(t) < colours.size().
void fill_triangles(Canvas& canvas, const MeshScene& scene, std::span<const Colour> colours,
                    const std::function<std::size_t(TriangleId)>& index_of);

/// The edges of the visible triangles, fainter where they are dense, so that a fine mesh keeps its shades.
///
/// cell_of  the cell of which each triangle is a part, or empty: edges within a cell are left out
/// throws   InputError if it does not fit the triangles
void stroke_edges(Canvas& canvas, const MeshScene& scene, Colour colour, double width,
                  std::span<const std::size_t> cell_of = {});

/// The boundary, one colour an entry of `colour_of` (by marker).
void stroke_boundary(Canvas& canvas, const MeshScene& scene, double width,
                     const std::function<Colour(Marker)>& colour_of);

}  // namespace leonhard::draw
