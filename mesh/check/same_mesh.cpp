// SPDX-License-Identifier: MIT
#include "leonhard/mesh/check/same_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::mesh {
namespace {

std::string digits_of(IdRaw raw) { return std::to_string(raw); }

[[noreturn]] void throw_foreign(const char* where, const std::string& what) {
  throw InputError(where, what + " is none of the mesh's",
                   "give what build_edges or build_faces makes of this mesh");
}

[[noreturn]] void throw_foreign(const char* where, const std::string& found, std::size_t wanted) {
  throw InputError(where, found + ", the mesh has " + std::to_string(wanted),
                   "give what build_edges or build_faces makes of this mesh");
}

/// Does the triangle run from a to b?
bool runs(const std::array<VertexId, 3>& corners, VertexId a, VertexId b) {
  return (corners[0] == a && corners[1] == b) || (corners[1] == a && corners[2] == b) ||
         (corners[2] == a && corners[0] == b);
}

/// Edges ascend, and first_edge says where those of each smaller end begin.
void require_sorted(std::size_t vertices, const PerId<EdgeId, std::array<VertexId, 2>>& ends,
                    const std::vector<IdRaw>& first_edge) {
  if (first_edge.size() != vertices + 1)
    throw_foreign("edges",
                  "edges of " + std::to_string(first_edge.empty() ? 0 : first_edge.size() - 1) + " vertices",
                  vertices);
  if (first_edge.front() != 0 || first_edge.back() != ends.size())
    throw_foreign("edges", "rows of " + digits_of(first_edge.back()) + " edges in a list of " +
                               std::to_string(ends.size()));
  for (const EdgeId e : ends.ids()) {
    const auto& [a, b] = ends[e];
    const bool is_sorted = e.index() == 0 || ends[EdgeId{static_cast<IdRaw>(e.raw - 1)}] < ends[e];
    if (!(a < b) || b.index() >= vertices || !is_sorted || first_edge[a.index()] > e.raw ||
        first_edge[a.index() + 1] <= e.raw)
      throw_foreign_edge(e, ends[e]);
  }
}

}  // namespace

void throw_foreign_edge(EdgeId e, const std::array<VertexId, 2>& ends) {
  throw_foreign("edges", "edge " + digits_of(e.raw) + ", from vertex " + digits_of(ends[0].raw) + " to " +
                             digits_of(ends[1].raw) + ",");
}

void require_edges_within(const TriangleMesh& mesh, const EdgeStructure& edges) {
  if (edges.sides.size() != edges.ends.size())
    throw_foreign("edges", "a list of " + std::to_string(edges.sides.size()) + " sides for " +
                               std::to_string(edges.ends.size()) + " edges");
  for (const EdgeId e : edges.ends.ids()) {
    const auto& [a, b] = edges.ends[e];
    const auto& [left, right] = edges.sides[e];
    const auto fits = [&](MaybeId<TriangleId> t, VertexId from, VertexId to) {
      return !t || (mesh.corners.contains(*t) && runs(mesh.corners[*t], from, to));
    };
    if (!(left || right) || !mesh.points.contains(a) || !mesh.points.contains(b) || !fits(left, a, b) ||
        !fits(right, b, a))
      throw_foreign_edge(e, edges.ends[e]);
  }
}

void require_edges_of(const TriangleMesh& mesh, const EdgeStructure& edges) {
  require_sorted(mesh.vertex_count(), edges.ends, edges.first_edge);
  require_edges_within(mesh, edges);
  // The sides are different edges of triangles, so that they are all if they are as many.
  std::size_t sides = 0;
  for (const auto& [left, right] : edges.sides)
    sides += static_cast<std::size_t>(left.has_value()) + static_cast<std::size_t>(right.has_value());
  if (sides != 3 * mesh.triangle_count())
    throw_foreign("edges", std::to_string(sides) + " sides of triangles", 3 * mesh.triangle_count());
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const MarkedEdge& edge = mesh.boundary[i];
    if (!mesh.points.contains(edge.from) || !mesh.points.contains(edge.to))
      throw InputError("mesh",
                       "boundary edge " + std::to_string(i) + " from vertex " + digits_of(edge.from.raw) +
                           " to " + digits_of(edge.to.raw) + ", the mesh has " +
                           std::to_string(mesh.vertex_count()) + " vertices",
                       "mesh::validate names what is wrong with a mesh");
  }
}

void require_faces_within(const TetMesh& mesh, const FaceStructure& faces) {
  if (faces.sides.size() != faces.corners.size())
    throw_foreign("faces", "a list of " + std::to_string(faces.sides.size()) + " sides for " +
                               std::to_string(faces.corners.size()) + " faces");
  for (const FaceId f : faces.corners.ids()) {
    const auto& corners = faces.corners[f];
    const auto fits = [&](MaybeId<TetId> t) {
      if (!t) return true;
      if (!mesh.corners.contains(*t)) return false;
      const auto& of_tet = mesh.corners[*t];
      return std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
        return std::find(of_tet.begin(), of_tet.end(), v) != of_tet.end();
      });
    };
    const auto& [one, other] = faces.sides[f];
    if (!(one || other) || !fits(one) || !fits(other))
      throw_foreign("faces", "face " + digits_of(f.raw) + ", of vertices " + digits_of(corners[0].raw) +
                                 ", " + digits_of(corners[1].raw) + " and " + digits_of(corners[2].raw) +
                                 ",");
  }
}

void require_edge_list_of(const TetMesh& mesh, const TetEdges& edges) {
  require_sorted(mesh.vertex_count(), edges.ends, edges.first_edge);
}

void require_boundary_within(const TetMesh& mesh) {
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    for (const VertexId v : mesh.boundary[i].corners)
      if (!mesh.points.contains(v))
        throw InputError("mesh",
                         "boundary face " + std::to_string(i) + " names vertex " + digits_of(v.raw) +
                             ", the mesh has " + std::to_string(mesh.vertex_count()) + " vertices",
                         "mesh::validate names what is wrong with a mesh");
}

}  // namespace leonhard::mesh
