// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// One side of a triangle, seen as a part of the undirected edge low-high.
struct HalfEdge {
  VertexId high;        ///< the edge's larger vertex
  TriangleId triangle;  ///< whose side it is
  std::uint8_t side;    ///< 0..2: opposite corners[triangle][side]
  bool forward;         ///< whether the triangle, walked counter-clockwise, goes low -> high
};

/// All sides of all triangles, grouped by smaller vertex, sorted by larger one within a group, then by
/// (triangle, side): the table from which neighbours and edges are read.
struct HalfEdgeTable {
  std::vector<HalfEdge> entries;   ///< 3 per triangle
  std::vector<std::size_t> first;  ///< entries with smaller vertex v are first[v] .. first[v + 1] - 1
};

/// The table of a mesh whose corners are in range and distinct within each triangle.
/// Cost O(vertices + triangles log degree).
[[nodiscard]] HalfEdgeTable half_edge_table(const TriangleMesh& mesh);

/// Words for the first edge that has more than two triangles or two that pass it in the same direction (a
/// triangle given twice included); none if every edge is that of an oriented surface.
[[nodiscard]] std::optional<std::string> broken_edge(const TriangleMesh& mesh, const HalfEdgeTable& table);

/// The neighbours that the table implies, shaped as TriangleMesh::neighbours. Every edge must be in order
/// (broken_edge).
[[nodiscard]] PerId<TriangleId, std::array<MaybeId<TriangleId>, 3>> neighbours_of(const TriangleMesh& mesh,
                                                                                  const HalfEdgeTable& table);

}  // namespace leonhard::mesh
