// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"

#include <algorithm>

#include "leonhard/delaunay/topology/tet_corners.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::delaunay {
namespace {

constexpr VertexId ghost = GhostTetrahedralization::ghost;

}  // namespace

DynamicTetrahedralization::DynamicTetrahedralization(std::span<const Point3> points, unsigned threads) {
  insert(points, threads);
}

void DynamicTetrahedralization::clear() { *this = {}; }

void DynamicTetrahedralization::require_living(VertexId v) const {
  if (!contains(v))
    throw InputError("vertex " + std::to_string(v.raw), "is not in the tetrahedralization",
                     "give the id of a vertex that was inserted and not removed");
}

std::vector<VertexId> DynamicTetrahedralization::neighbours(VertexId v) const {
  require_living(v);
  if (!has_tets()) return {};
  TetStar star;
  star.collect(cells_, tets_[v], v);
  std::vector<VertexId> all(star.neighbours().begin(), star.neighbours().end());
  std::sort(all.begin(), all.end());
  if (all.back() == ghost) all.pop_back();  // of the highest number
  return all;
}

std::vector<VertexQuadruple> DynamicTetrahedralization::tetrahedra_at(VertexId v) const {
  require_living(v);
  std::vector<VertexQuadruple> all;
  if (!has_tets()) return all;
  TetStar star;
  star.collect(cells_, tets_[v], v);
  for (const TetId t : star.tets())
    if (!cells_.is_ghost(t)) all.push_back(cells_.corners[t]);
  return all;
}

bool DynamicTetrahedralization::on_hull(VertexId v) const {
  require_living(v);
  if (!has_tets()) return true;
  TetStar star;
  star.collect(cells_, tets_[v], v);
  return std::any_of(star.tets().begin(), star.tets().end(), [&](TetId t) { return cells_.is_ghost(t); });
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
