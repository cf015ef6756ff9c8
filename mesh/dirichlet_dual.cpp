// SPDX-License-Identifier: MIT
#include "leonhard/mesh/dirichlet_dual.hpp"

#include "leonhard/kernel/constructions.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/check/same_mesh.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

/// The corner opposite a boundary edge.
Point2 opposite_corner(const TriangleMesh& mesh, const EdgeStructure& edges, const MarkedEdge& edge) {
  const MaybeId<EdgeId> found = edges.find(edge.from, edge.to);
  if (!found)
    throw InputError("mesh",
                     words(mesh, edge.from, edge.to) + " is listed as boundary, but no triangle has it",
                     "mesh::validate names what is wrong with a mesh");
  const auto& sides = edges.sides[*found];
  for (const VertexId v : mesh.corners[*(sides[0] ? sides[0] : sides[1])])
    if (v != edge.from && v != edge.to) return mesh.points[v];
  return mesh.points[edge.from];  // not reached: a triangle of the edge has a third corner
}

}  // namespace

DirichletDual dirichlet_dual(const TriangleMesh& mesh, const EdgeStructure& edges) {
  require_edges_of(mesh, edges);
  PerId<TriangleId, Point2> centres(mesh.triangle_count());
  for (const TriangleId t : mesh.corners.ids()) {
    const auto& [a, b, c] = mesh.corners[t];
    centres[t] = kernel::circumcircle(mesh.points[a], mesh.points[b], mesh.points[c]).centre;
  }
  DirichletDual dual{straight_dual(mesh, edges, centres), {}};
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const MarkedEdge& edge = mesh.boundary[i];
    const Point2 apex = opposite_corner(mesh, edges, edge);
    if (kernel::angle(mesh.points[edge.from], apex, mesh.points[edge.to]) == Sign::negative)
      dual.beyond.push_back(i);
  }
  return dual;
}

}  // namespace leonhard::mesh
