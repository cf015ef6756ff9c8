// SPDX-License-Identifier: MIT
#include "leonhard/mesh/ids_in_range.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::mesh {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw InputError("mesh", problem, "mesh::validate names all that is wrong with a mesh");
}

void require_size(const char* array, std::size_t size, std::size_t count, const char* of) {
  if (size != count)
    refuse(std::string(array) + " has " + std::to_string(size) + " entries for " + std::to_string(count) +
           " " + of);
}

[[noreturn]] void refuse_id(const std::string& where, IdRaw id, std::size_t count) {
  refuse(where + " names " + std::to_string(id) + ", the mesh has " + std::to_string(count));
}

template <class Mesh>
void require_corners(const Mesh& mesh, const std::string& cell) {
  const std::size_t vertices = mesh.points.size();
  for (const auto t : mesh.corners.ids())
    for (const VertexId v : mesh.corners[t])
      if (v.index() >= vertices) refuse_id(cell + " " + std::to_string(t.raw), v.raw, vertices);
}

template <class Mesh>
void require_cells(const Mesh& mesh, const std::string& cell, const char* cells) {
  require_size("neighbours", mesh.neighbours.size(), mesh.corners.size(), cells);
  require_size("regions", mesh.regions.size(), mesh.corners.size(), cells);
  require_size("vertex_markers", mesh.vertex_markers.size(), mesh.points.size(), "vertices");
  require_corners(mesh, cell);
  for (const auto t : mesh.neighbours.ids())
    for (const auto neighbour : mesh.neighbours[t])
      if (neighbour && !mesh.corners.contains(*neighbour))
        refuse_id("a neighbour of " + cell + " " + std::to_string(t.raw), (*neighbour).raw,
                  mesh.corners.size());
}

std::array<VertexId, 2> vertices_of(const MarkedEdge& edge) { return {edge.from, edge.to}; }
const std::array<VertexId, 3>& vertices_of(const MarkedFace& face) { return face.corners; }

template <class Mesh, class Marked>
void require_marked(const Mesh& mesh, const std::vector<Marked>& list, const char* name) {
  for (std::size_t i = 0; i < list.size(); ++i)
    for (const VertexId v : vertices_of(list[i]))
      if (!mesh.points.contains(v))
        refuse_id(std::string(name) + "[" + std::to_string(i) + "]", v.raw, mesh.points.size());
}

}  // namespace

void require_corners_in_range(const TriangleMesh& mesh) { require_corners(mesh, "triangle"); }
void require_corners_in_range(const TetMesh& mesh) { require_corners(mesh, "tetrahedron"); }

void require_ids_in_range(const TriangleMesh& mesh) {
  require_cells(mesh, "triangle", "triangles");
  require_marked(mesh, mesh.boundary, "boundary");
  require_marked(mesh, mesh.constraints, "constraints");
}

void require_ids_in_range(const TetMesh& mesh) {
  require_cells(mesh, "tetrahedron", "tetrahedra");
  require_marked(mesh, mesh.boundary, "boundary");
  require_marked(mesh, mesh.interfaces, "interfaces");
}

}  // namespace leonhard::mesh
