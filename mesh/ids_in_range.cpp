// SPDX-License-Identifier: MIT
#include "leonhard/mesh/ids_in_range.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::mesh {
namespace {

[[noreturn]] void refuse_ids(const std::string& problem) {
  throw InputError("mesh", problem, "mesh::validate names all that is wrong with a mesh");
}

void require_size(const char* array, std::size_t size, std::size_t count, const char* of) {
  if (size != count)
    refuse_ids(std::string(array) + " has " + std::to_string(size) + " entries for " + std::to_string(count) +
               " " + of);
}

[[noreturn]] void refuse_id(const std::string& where, IdRaw id, std::size_t count) {
  refuse_ids(where + " names " + std::to_string(id) + ", the mesh has " + std::to_string(count));
}

template <int Dim>
void require_facets_in_range(const SimplexMesh<Dim>& mesh,
                             const std::vector<typename Simplex<Dim>::MarkedFacet>& facets,
                             const char* name) {
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (const VertexId v : Simplex<Dim>::corners_of(facets[i]))
      if (!mesh.points.contains(v))
        refuse_id(std::string(name) + " " + Simplex<Dim>::facet + " " + std::to_string(i), v.raw,
                  mesh.vertex_count());
}

}  // namespace

template <int Dim>
void require_corners_in_range(const SimplexMesh<Dim>& mesh) {
  const std::size_t vertices = mesh.vertex_count();
  for (const auto t : mesh.corners.ids())
    for (const VertexId v : mesh.corners[t])
      if (v.index() >= vertices)
        refuse_id(std::string(Simplex<Dim>::cell) + " " + std::to_string(t.raw), v.raw, vertices);
}

template <int Dim>
void require_boundary_in_range(const SimplexMesh<Dim>& mesh) {
  require_facets_in_range(mesh, mesh.boundary, "boundary");
}

template <int Dim>
void require_ids_in_range(const SimplexMesh<Dim>& mesh) {
  require_size("neighbours", mesh.neighbours.size(), mesh.cell_count(), Simplex<Dim>::cells);
  require_size("regions", mesh.regions.size(), mesh.cell_count(), Simplex<Dim>::cells);
  require_size("vertex_markers", mesh.vertex_markers.size(), mesh.vertex_count(), "vertices");
  require_corners_in_range(mesh);
  for (const auto t : mesh.neighbours.ids())
    for (const auto neighbour : mesh.neighbours[t])
      if (neighbour && !mesh.corners.contains(*neighbour))
        refuse_id(std::string("as neighbour, ") + Simplex<Dim>::cell + " " + std::to_string(t.raw),
                  (*neighbour).raw, mesh.cell_count());
  require_boundary_in_range(mesh);
  require_facets_in_range(mesh, mesh.inner_facets(), "inner");
}

template void require_ids_in_range(const SimplexMesh<2>&);
template void require_ids_in_range(const SimplexMesh<3>&);
template void require_corners_in_range(const SimplexMesh<2>&);
template void require_corners_in_range(const SimplexMesh<3>&);
template void require_boundary_in_range(const SimplexMesh<2>&);
template void require_boundary_in_range(const SimplexMesh<3>&);

}  // namespace leonhard::mesh
