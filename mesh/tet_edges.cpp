// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_edges.hpp"

#include <string>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/faces.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/structures/edges_of_pairs.hpp"

namespace leonhard {

namespace mesh {

TetEdges build_edges(const TetMesh& mesh) {
  require_corners_in_range(mesh);
  return edges_of(mesh.vertex_count(), [&](auto visit) {
    for (const auto& corners : mesh.corners) {
      for (const auto& [i, j] : tet_edge_corners) visit(corners[i], corners[j]);
    }
  });
}

TetEdges build_edges(const FaceStructure& faces, std::size_t vertices) {
  for (const FaceId f : faces.corners.ids())
    for (const VertexId v : faces.corners[f])
      if (v.index() >= vertices)
        throw InputError("faces",
                         "face " + std::to_string(f.raw) + " names vertex " + std::to_string(v.raw) + " of " +
                             std::to_string(vertices),
                         "give the number of the mesh's vertices");
  return edges_of(vertices, [&](auto visit) {
    for (const auto& [a, b, c] : faces.corners) visit(a, b), visit(a, c), visit(b, c);
  });
}

}  // namespace mesh
}  // namespace leonhard
