// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

using HistoryNodeId = Id<struct HistoryNodeTag>;

/// All triangles that an incremental construction ever made: each one has those as children that took its
/// place. A point is located by going down from the first triangle. Guibas, Knuth and Sharir, "Randomized
/// incremental construction of Delaunay and Voronoi diagrams", Algorithmica 7 (1992); after random insertions
/// the way down is O(log n) long on the average.
///
/// Real triangles are closed. A ghost triangle (ghost, a, b) stands for what lies strictly outside the edge a
/// -> b between the rays through a and b from a point o inside the first triangle. So the nodes without
/// children cover each point, and the children of a node cover the node. The point o is one of infinitesimal
/// barycentric coordinates, (1 - e - e^2, e, e^2): the side of a ray on which a point lies is the first of
/// the signs of orient2d with the first triangle's corners that is not zero.
class TriangleHistory {
 public:
  /// Begin with a triangulation that has just been started: one real triangle and three ghosts.
  void start(const GhostTriangulation& in);
  void reserve(std::size_t points);

  /// Triangles `olds` gave way to `news`; a hook of SwapInsertion.
  void replaced(const GhostTriangulation& in, std::span<const AnyTriangleId> olds,
                std::span<const AnyTriangleId> news);

  /// The triangle of today's triangulation that holds p: real if p lies in one, on its border perhaps; else a
  /// ghost triangle, p strictly outside its edge.
  [[nodiscard]] AnyTriangleId find(std::span<const Point2> points, Point2 p) const;

  /// The first triangle is node 0, its ghosts are nodes 1 to 3; children come after their parents.
  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }
  /// Counter-clockwise; the ghost, if any, first.
  [[nodiscard]] const std::array<VertexId, 3>& corners(HistoryNodeId n) const { return nodes_[n].corners; }
  /// 0 of triangles that are there still.
  [[nodiscard]] std::size_t child_count(HistoryNodeId n) const { return nodes_[n].child_count; }
  [[nodiscard]] HistoryNodeId child(HistoryNodeId n, std::size_t i) const {
    return HistoryNodeId::from(nodes_[n].first_child + i);
  }

 private:
  struct Node {
    std::array<VertexId, 3> corners;
    IdRaw first_child;  ///< children have consecutive numbers; without children, the triangle
    IdRaw child_count;
  };

  void add_node(const GhostTriangulation& in, AnyTriangleId t);
  [[nodiscard]] bool holds(HistoryNodeId n, std::span<const Point2> points, Point2 p) const;
  [[nodiscard]] bool left_of_ray(VertexId through, std::span<const Point2> points, Point2 p) const;
  [[nodiscard]] HistoryNodeId holder(HistoryNodeId first, std::size_t count, std::span<const Point2> points,
                                     Point2 p) const;

  PerId<HistoryNodeId, Node> nodes_;
  PerId<AnyTriangleId, HistoryNodeId> node_of_;
};

}  // namespace leonhard::delaunay
