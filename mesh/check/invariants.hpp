// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/structures/half_edges.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// The invariants of TriangleMesh one by one, each in words for the first place where it is broken. `validate` and
/// `make_triangle_mesh` ask the same ones. A function may rely on those declared before it.
namespace leonhard::mesh {

/// One entry per vertex or triangle in each array that has to have one.
[[nodiscard]] std::optional<std::string> broken_sizes(const TriangleMesh& mesh);

/// Every coordinate is finite.
[[nodiscard]] std::optional<std::string> broken_point(const TriangleMesh& mesh);

/// Every corner is a vertex, no triangle names one twice.
[[nodiscard]] std::optional<std::string> broken_corner(const TriangleMesh& mesh);

/// Every vertex has a triangle.
[[nodiscard]] std::optional<std::string> unused_vertex(const TriangleMesh& mesh);

/// Every triangle is counter-clockwise, by exact orient2d.
[[nodiscard]] std::optional<std::string> broken_orientation(const TriangleMesh& mesh);

/// mesh.neighbours says what the table of half-edges says.
[[nodiscard]] std::optional<std::string> broken_neighbour(const TriangleMesh& mesh,
                                                          const HalfEdgeTable& table);

/// The edges of mesh.neighbours without a triangle behind, each directed with the mesh on its left.
class BoundaryEdges {
 public:
  struct Edge {
    VertexId from, to;
    TriangleId triangle;
  };
  explicit BoundaryEdges(const TriangleMesh& mesh);

  /// Sorted by (from, to).
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// Index in edges() of the edge in this direction. Cost O(log boundary).
  [[nodiscard]] std::optional<std::size_t> find(VertexId from, VertexId to) const;

 private:
  std::vector<Edge> edges_;
};

/// mesh.boundary has each boundary edge once, with the mesh on its left.
[[nodiscard]] std::optional<std::string> broken_boundary(const TriangleMesh& mesh,
                                                         const BoundaryEdges& edges);

/// mesh.constraints has interior edges only.
[[nodiscard]] std::optional<std::string> broken_constraint(const TriangleMesh& mesh,
                                                           const HalfEdgeTable& table);

}  // namespace leonhard::mesh
