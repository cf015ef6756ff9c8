// SPDX-License-Identifier: MIT
#include "leonhard/mesh/permute.hpp"

#include <algorithm>
#include <vector>

#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/structures/permutation.hpp"

namespace leonhard::mesh {
namespace {

using Corners = std::array<VertexId, 3>;

/// order[new] = old number of a triangle.
std::vector<TriangleId> triangle_order(const PerId<TriangleId, Corners>& corners, TriangleOrder order) {
  std::vector<TriangleId> old_of_new(corners.ids().begin(), corners.ids().end());
  if (order == TriangleOrder::kept) return old_of_new;
  PerId<TriangleId, Corners> keys = corners;
  for (Corners& key : keys) std::sort(key.begin(), key.end());
  std::sort(old_of_new.begin(), old_of_new.end(),
            [&](TriangleId s, TriangleId t) { return keys[s] != keys[t] ? keys[s] < keys[t] : s < t; });
  return old_of_new;
}

std::vector<MarkedEdge> renumbered(std::vector<MarkedEdge> edges,
                                   const PerId<VertexId, VertexId>& new_of_old) {
  for (MarkedEdge& edge : edges) edge = {new_of_old[edge.from], new_of_old[edge.to], edge.marker};
  return edges;
}

}  // namespace

TriangleMesh renumber_vertices(const TriangleMesh& mesh, const PerId<VertexId, VertexId>& new_of_old,
                               TriangleOrder order) {
  check_permutation(mesh.vertex_count(), new_of_old);
  require_ids_in_range(mesh);
  TriangleMesh result;
  result.marker_names = mesh.marker_names;
  result.boundary = renumbered(mesh.boundary, new_of_old);
  result.constraints = renumbered(mesh.constraints, new_of_old);
  result.points = renumbered(mesh.points, new_of_old);
  result.vertex_markers = renumbered(mesh.vertex_markers, new_of_old);

  PerId<TriangleId, Corners> corners = mesh.corners;
  for (Corners& triangle : corners) {
    for (VertexId& v : triangle) v = new_of_old[v];
  }
  const std::vector<TriangleId> old_of_new = triangle_order(corners, order);
  PerId<TriangleId, TriangleId> new_triangle(mesh.triangle_count());
  for (std::size_t i = 0; i < old_of_new.size(); ++i) new_triangle[old_of_new[i]] = TriangleId::from(i);

  result.corners.reserve(mesh.triangle_count());
  result.neighbours.reserve(mesh.neighbours.size());
  result.regions.reserve(mesh.regions.size());
  for (const TriangleId old : old_of_new) {
    result.corners.push_back(corners[old]);
    std::array<MaybeId<TriangleId>, 3> neighbours = mesh.neighbours[old];
    for (MaybeId<TriangleId>& neighbour : neighbours) {
      if (neighbour) neighbour = new_triangle[*neighbour];
    }
    result.neighbours.push_back(neighbours);
    result.regions.push_back(mesh.regions[old]);
  }
  return result;
}

}  // namespace leonhard::mesh
