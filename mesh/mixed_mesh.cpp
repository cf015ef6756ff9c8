// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mixed_mesh.hpp"

#include <cassert>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/check/mixed_invariants.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard {

template <int Dim>
MixedFacet<Dim>::MixedFacet(std::span<const VertexId> vertices)
    : count_(static_cast<std::uint8_t>(vertices.size())) {
  assert(vertices.size() >= Dim && vertices.size() <= most_corners);
  std::copy(vertices.begin(), vertices.end(), vertices_.begin());
}

template <int Dim>
MixedFacet<Dim> MixedFacet<Dim>::reversed() const {
  MixedFacet other = *this;
  std::reverse(other.vertices_.begin() + (Dim == 2 ? 0 : 1), other.vertices_.begin() + count_);
  return other;
}

template <int Dim>
MixedFacet<Dim> MixedMesh<Dim>::facet_of(CellId cell, std::size_t side) const {
  const FacetShape& shape_of_side = shape(cell).facets[side];
  const auto of_cell = corners_of(cell);
  std::array<VertexId, Facet::most_corners> vertices;
  for (std::size_t i = 0; i < shape_of_side.size(); ++i) vertices[i] = of_cell[shape_of_side[i]];
  return Facet(std::span<const VertexId>(vertices.data(), shape_of_side.size()));
}

template <int Dim>
CellId MixedMesh<Dim>::add_cell(CellKind kind, std::span<const VertexId> vertices) {
  assert(vertices.size() == shape_of(kind).corner_count);
  for (const VertexId v : vertices) corners.add_link(v);
  corners.end_row();
  regions.push_back(0);
  return kinds.push_back(kind);
}

template class MixedFacet<2>;
template class MixedFacet<3>;
template struct MixedMesh<2>;
template struct MixedMesh<3>;

namespace mesh {
namespace {

template <int Dim>
std::vector<MarkedMixedFacet<Dim>> mixed_facets(
    const std::vector<typename Simplex<Dim>::MarkedFacet>& facets) {
  std::vector<MarkedMixedFacet<Dim>> mixed;
  mixed.reserve(facets.size());
  for (const auto& facet : facets) {
    const std::array<VertexId, Dim> corners = Simplex<Dim>::corners_of(facet);
    mixed.push_back({MixedFacet<Dim>(std::span<const VertexId>(corners)), facet.marker});
  }
  return mixed;
}

/// facets  of simplices alone
template <int Dim>
std::vector<typename Simplex<Dim>::MarkedFacet> simplex_facets(
    const MixedMesh<Dim>& mesh, const std::vector<MarkedMixedFacet<Dim>>& facets) {
  std::vector<typename Simplex<Dim>::MarkedFacet> simple;
  simple.reserve(facets.size());
  for (const auto& [corners, marker] : facets) {
    if (corners.size() != Dim)
      throw InputError("mesh", words(mesh, corners) + " has " + std::to_string(corners.size()) + " corners",
                       "faces of tetrahedra have three");
    std::array<VertexId, Dim> of_simplex;
    std::copy(corners.begin(), corners.end(), of_simplex.begin());
    simple.push_back(Simplex<Dim>::marked(of_simplex, marker));
  }
  return simple;
}

}  // namespace

template <int Dim>
void require_ids_in_range(const MixedMesh<Dim>& mesh) {
  const std::string remedy = "mesh::validate names what is wrong with a mesh";
  refuse(broken_sizes(mesh), "mesh", remedy);
  refuse(broken_kind(mesh), "mesh", remedy);
  refuse(corner_out_of_range(mesh), "mesh", remedy);
}

template <int Dim>
MixedMesh<Dim> mixed_mesh_of(const SimplexMesh<Dim>& mesh) {
  require_ids_in_range(mesh);
  MixedMesh<Dim> mixed;
  mixed.points = mesh.points;
  mixed.kinds.resize(mesh.cell_count(), simplex_kind<Dim>);
  mixed.corners.reserve(mesh.cell_count(), (Dim + 1) * mesh.cell_count());
  for (const auto& corners : mesh.corners) {
    for (const VertexId v : corners) mixed.corners.add_link(v);
    mixed.corners.end_row();
  }
  mixed.boundary = mixed_facets<Dim>(mesh.boundary);
  mixed.inner_facets = mixed_facets<Dim>(mesh.inner_facets());
  mixed.vertex_markers = mesh.vertex_markers;
  mixed.regions = PerId<CellId, double>(mesh.regions.flat());
  mixed.marker_names = mesh.marker_names;
  mixed.region_names = mesh.region_names;
  return mixed;
}

template <int Dim>
SimplexMesh<Dim> simplex_mesh_of(const MixedMesh<Dim>& mixed) {
  require_ids_in_range(mixed);
  SimplexMesh<Dim> mesh;
  mesh.corners.reserve(mixed.cell_count());
  for (const CellId cell : mixed.kinds.ids()) {
    if (mixed.kinds[cell] != simplex_kind<Dim>)
      throw InputError("mesh", words(mixed, cell) + " is no " + Simplex<Dim>::cell,
                       std::string("give a mesh of ") + Simplex<Dim>::cells + " alone");
    std::array<VertexId, Dim + 1> corners;
    const auto of_cell = mixed.corners_of(cell);
    std::copy(of_cell.begin(), of_cell.end(), corners.begin());
    mesh.corners.push_back(corners);
  }
  mesh.points = mixed.points;
  mesh.boundary = simplex_facets(mixed, mixed.boundary);
  mesh.inner_facets() = simplex_facets(mixed, mixed.inner_facets);
  mesh.vertex_markers = mixed.vertex_markers;
  mesh.regions = PerId<typename Simplex<Dim>::CellId, double>(mixed.regions.flat());
  mesh.marker_names = mixed.marker_names;
  mesh.region_names = mixed.region_names;
  build_neighbours(mesh);
  return mesh;
}

template void require_ids_in_range(const MixedMesh<2>&);
template void require_ids_in_range(const MixedMesh<3>&);
template MixedMesh<2> mixed_mesh_of(const SimplexMesh<2>&);
template MixedMesh<3> mixed_mesh_of(const SimplexMesh<3>&);
template SimplexMesh<2> simplex_mesh_of(const MixedMesh<2>&);
template SimplexMesh<3> simplex_mesh_of(const MixedMesh<3>&);

}  // namespace mesh
}  // namespace leonhard
