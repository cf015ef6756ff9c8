// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard {

struct FaceStructure;

/// The edges of a tetrahedral mesh, sorted by (ends[0], ends[1]), so that their numbers depend on the vertices' numbers
/// alone.
struct TetEdges {
  PerId<EdgeId, std::array<VertexId, 2>> ends;  ///< ends[e][0] < ends[e][1]
  std::vector<IdRaw> first_edge;  ///< edges with ends[0] == v are first_edge[v] .. first_edge[v + 1] - 1

  [[nodiscard]] std::size_t edge_count() const { return ends.size(); }

  /// The edge between two vertices, given in either order; none if there is no such edge. Cost O(log degree).
  [[nodiscard]] MaybeId<EdgeId> find(VertexId a, VertexId b) const;
};

namespace mesh {

/// The edges of a mesh, from its corners alone, whatever is wrong with its faces.
///
/// throws  InputError on a corner that is no vertex
/// Cost O(vertices + tetrahedra), one sort by buckets.
[[nodiscard]] TetEdges build_edges(const TetMesh& mesh);

/// The edges of faces.
///
/// vertices  their count
/// throws    InputError if a corner is none of them
/// Cost O(vertices + faces), one sort by buckets.
[[nodiscard]] TetEdges build_edges(const FaceStructure& faces, std::size_t vertices);

}  // namespace mesh
}  // namespace leonhard
