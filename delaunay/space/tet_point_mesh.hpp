// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::delaunay {

/// Where sorted points come from.
struct SortedOrigin {
  std::vector<std::uint32_t> first_input;   ///< one a sorted point: the first input point there
  std::vector<std::uint32_t> sorted_index;  ///< one an input point: its sorted point
};

struct TetPointMesh {
  TetMesh mesh;
  std::vector<MaybeId<VertexId>> vertex_of_input;  ///< one an input point, never none; duplicates share one
};

/// The tetrahedralisation of a point set as a mesh. Vertices are numbered in the order of the input points that made
/// them; boundary faces, marker 1, come in the order of their tetrahedra.
///
/// cells   real tetrahedra alone (tet_sort.hpp); its vertices are the sorted points
/// input   becomes the mesh's points
[[nodiscard]] TetPointMesh to_mesh(GhostTetrahedralization cells, SortedOrigin origin,
                                   std::vector<Point3> input, unsigned threads);

}  // namespace leonhard::delaunay
