// SPDX-License-Identifier: MIT
#include "leonhard/mesh/validate.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/structures/half_edges.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

using VertexPair = std::pair<VertexId, VertexId>;

std::vector<VertexPair> sorted_constraints(const TriangleMesh& mesh) {
  std::vector<VertexPair> pairs;
  for (const MarkedEdge& edge : mesh.constraints) {
    pairs.emplace_back(std::min(edge.from, edge.to), std::max(edge.from, edge.to));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The corner of t that does not lie on its edge to `other`.
VertexId corner_opposite(const TriangleMesh& mesh, TriangleId t, TriangleId other) {
  const auto& neighbours = mesh.neighbours[t];
  const auto side =
      std::find(neighbours.begin(), neighbours.end(), MaybeId<TriangleId>(other)) - neighbours.begin();
  return mesh.corners[t][static_cast<std::size_t>(side)];
}

}  // namespace

std::optional<std::string> validate(const TriangleMesh& mesh) {
  if (auto problem = broken_sizes(mesh)) return problem;
  if (auto problem = broken_point(mesh)) return problem;
  if (auto problem = broken_corner(mesh)) return problem;
  if (auto problem = unused_vertex(mesh)) return problem;
  if (auto problem = broken_orientation(mesh)) return problem;
  const HalfEdgeTable table = half_edge_table(mesh);
  if (auto problem = broken_edge(mesh, table)) return problem;
  if (auto problem = broken_neighbour(mesh, table)) return problem;
  if (auto problem = broken_boundary(mesh, BoundaryEdges(mesh))) return problem;
  return broken_constraint(mesh, table);
}

std::optional<std::string> validate_delaunay(const TriangleMesh& mesh) {
  std::optional<std::vector<VertexPair>> constraints;  // made when the first edge fails
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& [a, b, c] = mesh.corners[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const MaybeId<TriangleId> neighbour = mesh.neighbours[t][i];
      if (!neighbour || *neighbour < t) continue;
      const VertexId d = corner_opposite(mesh, *neighbour, t);
      if (kernel::incircle(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]) != Sign::positive)
        continue;
      const VertexId from = mesh.corners[t][(i + 1) % 3], to = mesh.corners[t][(i + 2) % 3];
      if (!constraints) constraints = sorted_constraints(mesh);
      const VertexPair edge(std::min(from, to), std::max(from, to));
      if (std::binary_search(constraints->begin(), constraints->end(), edge)) continue;
      return words(mesh, from, to) + " is not locally Delaunay: " + words(mesh, d) +
             ", a corner of triangle " + std::to_string((*neighbour).raw) +
             ", lies inside the circumcircle of " + words(mesh, t);
    }
  }
  return std::nullopt;
}

}  // namespace leonhard::mesh
