// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The triangles about a vertex, and those that take their place when it is removed: Cavity backwards.
///
/// What replaces the star of v in the Delaunay triangulation without v is exactly the cavity that an
/// insertion of v would destroy. So the hole is filled without new vertices, with triangles (ghosts among
/// them) that are Delaunay for the vertices of the link alone; as ties are broken by coordinates there is one
/// such filling. Buffers are kept from one removal to the next.
class Star {
 public:
  struct Link {
    SideId outer;   ///< twin of the link's edge: runs from the next vertex of the link to this one
    VertexId from;  ///< the edge's origin
  };

  /// Collect the star of the origin of a side.
  void start(const GhostTriangulation& in, SideId side);

  /// The edges opposite the vertex, counter-clockwise; the ghost comes last if it is there.
  [[nodiscard]] const std::vector<Link>& link() const { return link_; }
  /// Whether the vertex lies on the convex hull.
  [[nodiscard]] bool has_ghost() const { return link_.back().from == GhostTriangulation::ghost; }
  /// The star's triangles; after fill, those that were given new corners and at the end two to which nothing
  /// is linked any more.
  [[nodiscard]] const std::vector<AnyTriangleId>& triangles() const { return triangles_; }

  /// Replace the star by the Delaunay triangulation of the hole, with two triangles less. The link is used
  /// up. The vertices without the centre must not all be collinear.
  ///
  /// Cost O(degree log degree): a pass over the link for each triangle while these are few; else the whole
  /// Delaunay triangulation of the link's vertices, of which the hole's part is taken.
  ///
  /// few  up to how many vertices of the link count as few, at least 3; the answer does not depend on it
  void fill(GhostTriangulation& in, std::span<const Point2> points, std::size_t few = 64);

 private:
  void fill_directly();
  void fill_about_ghost();
  SideId fill_chain(std::size_t first, std::size_t last);
  void fill_from_whole();
  void copy_part(const GhostTriangulation& whole);
  std::size_t apex(VertexId from, VertexId to, std::size_t begin, std::size_t end) const;
  AnyTriangleId take(VertexId a, VertexId b, VertexId c);
  [[nodiscard]] Point2 at(VertexId v) const { return points_[v.index()]; }

  std::vector<Link> link_;
  std::vector<AnyTriangleId> triangles_;
  std::size_t taken_ = 0;
  GhostTriangulation* in_ = nullptr;  // while filling
  std::span<const Point2> points_;
};

}  // namespace leonhard::delaunay
