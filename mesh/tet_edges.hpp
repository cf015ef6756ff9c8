// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "leonhard/mesh/edge_list.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard {

struct FaceStructure;

/// The edges of a tetrahedral mesh.
using TetEdges = EdgeList;

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
