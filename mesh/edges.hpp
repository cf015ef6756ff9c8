// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// The edge structure of Barth's notes 1.3 (figure 1.3.0 b): of each edge its two vertices and the two
/// triangles that share it. Edges are sorted by (ends[0], ends[1]), so their numbers depend on the vertices'
/// numbers alone.
struct EdgeStructure {
  PerId<EdgeId, std::array<VertexId, 2>> ends;  ///< ends[e][0] < ends[e][1]
  PerId<EdgeId, std::array<MaybeId<TriangleId>, 2>>
      sides;                      ///< [0] left of ends[0] -> ends[1], [1] right of it
  std::vector<IdRaw> first_edge;  ///< edges with ends[0] == v are first_edge[v] .. first_edge[v + 1] - 1

  [[nodiscard]] std::size_t edge_count() const { return ends.size(); }
  [[nodiscard]] bool is_boundary(EdgeId e) const { return !sides[e][0] || !sides[e][1]; }

  /// The edge between two vertices, given in either order; none if there is no such edge. Cost O(log degree).
  [[nodiscard]] MaybeId<EdgeId> find(VertexId a, VertexId b) const;
};

namespace mesh {

/// The edge structure of a mesh, from its corners alone: neighbours and boundary are not read, so the counts
/// are independent of them.
///
/// throws  InputError as build_neighbours does
/// Cost O(vertices + triangles), one sort by buckets.
[[nodiscard]] EdgeStructure build_edges(const TriangleMesh& mesh);

}  // namespace mesh
}  // namespace leonhard
