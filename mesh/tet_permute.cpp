// SPDX-License-Identifier: MIT
#include "leonhard/mesh/tet_permute.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/structures/permutation.hpp"

namespace leonhard::mesh {
namespace {

using Corners = std::array<VertexId, 4>;

/// order[new] = old number of a tetrahedron: in buckets by smallest vertex, each sorted.
std::vector<TetId> order_by_vertices(const PerId<TetId, Corners>& corners, std::size_t vertices) {
  struct Entry {
    std::array<VertexId, 3> higher;
    TetId tet;
  };
  std::vector<std::size_t> first(vertices + 1, 0);
  for (const Corners& c : corners) ++first[std::min({c[0], c[1], c[2], c[3]}).index() + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<Entry> entries(corners.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const TetId t : corners.ids()) {
    Corners key = corners[t];
    std::sort(key.begin(), key.end());
    entries[next[key[0].index()]++] = {{key[1], key[2], key[3]}, t};
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(entries.begin() + static_cast<std::ptrdiff_t>(first[v]),
              entries.begin() + static_cast<std::ptrdiff_t>(first[v + 1]),
              [](const Entry& a, const Entry& b) {
                return a.higher != b.higher ? a.higher < b.higher : a.tet < b.tet;
              });
  }
  std::vector<TetId> old_of_new;
  old_of_new.reserve(entries.size());
  for (const Entry& entry : entries) old_of_new.push_back(entry.tet);
  return old_of_new;
}

std::vector<MarkedFace> renumbered(std::vector<MarkedFace> faces,
                                   const PerId<VertexId, VertexId>& new_of_old) {
  for (MarkedFace& face : faces) {
    for (VertexId& v : face.corners) v = new_of_old[v];
  }
  return faces;
}

/// The same mesh, its tetrahedra in another order.
void reorder_tets(TetMesh& mesh, const std::vector<TetId>& old_of_new) {
  PerId<TetId, TetId> new_of_old(mesh.tet_count());
  for (std::size_t i = 0; i < old_of_new.size(); ++i) new_of_old[old_of_new[i]] = TetId::from(i);
  PerId<TetId, Corners> corners;
  PerId<TetId, std::array<MaybeId<TetId>, 4>> neighbours;
  PerId<TetId, double> regions;
  corners.reserve(mesh.tet_count());
  neighbours.reserve(mesh.tet_count());
  regions.reserve(mesh.tet_count());
  for (const TetId old : old_of_new) {
    corners.push_back(mesh.corners[old]);
    regions.push_back(mesh.regions[old]);
    std::array<MaybeId<TetId>, 4> across = mesh.neighbours[old];
    for (MaybeId<TetId>& neighbour : across) {
      if (neighbour) neighbour = new_of_old[*neighbour];
    }
    neighbours.push_back(across);
  }
  mesh.corners = std::move(corners);
  mesh.neighbours = std::move(neighbours);
  mesh.regions = std::move(regions);
}

}  // namespace

TetMesh renumber_vertices(const TetMesh& mesh, const PerId<VertexId, VertexId>& new_of_old, TetOrder order) {
  check_permutation(mesh.vertex_count(), new_of_old);
  require_ids_in_range(mesh);
  TetMesh result;
  result.points = renumbered(mesh.points, new_of_old);
  result.vertex_markers = renumbered(mesh.vertex_markers, new_of_old);
  result.boundary = renumbered(mesh.boundary, new_of_old);
  result.interfaces = renumbered(mesh.interfaces, new_of_old);
  result.marker_names = mesh.marker_names;
  result.neighbours = mesh.neighbours;
  result.regions = mesh.regions;
  result.corners = mesh.corners;
  for (Corners& corners : result.corners) {
    for (VertexId& v : corners) v = new_of_old[v];
  }
  if (order == TetOrder::by_smallest_vertex)
    reorder_tets(result, order_by_vertices(result.corners, result.vertex_count()));
  return result;
}

}  // namespace leonhard::mesh
