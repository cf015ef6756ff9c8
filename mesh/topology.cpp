// SPDX-License-Identifier: MIT
#include "leonhard/mesh/topology.hpp"

#include <optional>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/structures/half_edges.hpp"

namespace leonhard::mesh {
namespace {

void refuse(const std::optional<std::string>& problem, const std::string& source, const char* remedy) {
  if (problem) throw InputError(source, *problem, remedy);
}

constexpr const char* correct_cells = "correct the list of triangles";

/// Turns marked edges so that the mesh lies on their left; those that are no boundary edges stay as they are.
void turn_boundary(std::vector<MarkedEdge>& boundary, const BoundaryEdges& edges) {
  for (MarkedEdge& edge : boundary) {
    if (edges.find(edge.to, edge.from)) std::swap(edge.from, edge.to);
  }
}

}  // namespace

void build_neighbours(TriangleMesh& mesh) {
  refuse(broken_corner(mesh), "", correct_cells);
  const HalfEdgeTable table = half_edge_table(mesh);
  refuse(broken_edge(mesh, table), "", correct_cells);
  mesh.neighbours = neighbours_of(mesh, table);
}

TriangleMesh make_triangle_mesh(PerId<VertexId, Point2> points,
                                PerId<TriangleId, std::array<VertexId, 3>> corners,
                                std::vector<MarkedEdge> boundary, std::map<Marker, std::string> names,
                                std::string source) {
  TriangleMesh mesh;
  mesh.points = std::move(points);
  mesh.corners = std::move(corners);
  mesh.boundary = std::move(boundary);
  mesh.marker_names = std::move(names);
  mesh.vertex_markers.resize(mesh.vertex_count(), 0);
  mesh.regions.resize(mesh.triangle_count(), 0.0);

  refuse(broken_point(mesh), source, "correct its coordinates");
  refuse(broken_corner(mesh), source, "correct the triangle's vertices");
  refuse(unused_vertex(mesh), source, "remove the vertex or restore the triangles about it");
  refuse(broken_orientation(mesh), source,
         "list its vertices counter-clockwise, or move one so that it has an area");
  const HalfEdgeTable table = half_edge_table(mesh);
  refuse(broken_edge(mesh, table), source, correct_cells);
  mesh.neighbours = neighbours_of(mesh, table);

  const BoundaryEdges edges(mesh);
  turn_boundary(mesh.boundary, edges);
  refuse(broken_boundary(mesh, edges), source,
         "every boundary edge needs exactly one marker; if the edge should not be on the boundary, a "
         "triangle is "
         "missing or two vertices stand for one");
  return mesh;
}

}  // namespace leonhard::mesh
