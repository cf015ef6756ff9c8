// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"

#include "leonhard/delaunay/topology/tet_corners.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::delaunay {

DynamicTetrahedralization::DynamicTetrahedralization(std::span<const Point3> points, unsigned threads) {
  insert(points, threads);
}

void DynamicTetrahedralization::clear() { *this = {}; }

void DynamicTetrahedralization::require_living(VertexId v) const {
  if (!contains(v))
    throw InputError("vertex " + std::to_string(v.raw), "is not in the tetrahedralization",
                     "give the id of a vertex that was inserted and not removed");
}

DynamicTetrahedralization::Mesh DynamicTetrahedralization::to_mesh() const {
  Mesh result;
  result.mesh_vertex.resize(id_bound());
  if (!has_tets()) return result;
  TetMesh& mesh = result.mesh;
  for (const VertexId v : vertices()) result.mesh_vertex[v.index()] = mesh.points.push_back(points_[v]);
  mesh.vertex_markers.resize(mesh.points.size(), 0);

  const auto mesh_vertex = [&](VertexId v) { return *result.mesh_vertex[v.index()]; };
  std::vector<MaybeId<TetId>> mesh_tet(cells_.tet_count());  // none for ghosts
  for (const TetId t : cells_.corners.ids()) {
    if (cells_.is_ghost(t)) continue;
    TetCorners corners = cells_.corners[t];
    for (VertexId& v : corners) v = mesh_vertex(v);
    mesh_tet[t.index()] = mesh.corners.push_back(corners);
  }
  for (const TetId t : cells_.corners.ids()) {
    if (cells_.is_ghost(t)) continue;
    std::array<MaybeId<TetId>, 4> neighbours = cells_.neighbours[t];
    const TetCorners& corners = mesh.corners[*mesh_tet[t.index()]];
    for (unsigned i = 0; i < 4; ++i) {
      neighbours[i] = mesh_tet[(*neighbours[i]).index()];
      const auto& [a, b, c] = tet_face_corners[i];
      if (!neighbours[i]) mesh.boundary.push_back({{corners[a], corners[b], corners[c]}, 1});
    }
    mesh.neighbours.push_back(neighbours);
  }
  mesh.regions.resize(mesh.corners.size(), 0);
  return result;
}

}  // namespace leonhard::delaunay
