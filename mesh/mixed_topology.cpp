// SPDX-License-Identifier: MIT
#include "leonhard/mesh/mixed_topology.hpp"

#include <utility>

#include "leonhard/mesh/check/mixed_invariants.hpp"

namespace leonhard::mesh {
namespace {

/// A facet of one cell, directed out of it.
template <int Dim>
MixedFacet<Dim> outward(const MixedSide<Dim>& side) {
  const MixedFacet<Dim> facet = facet_of_ring<Dim>(side.ring);
  return side.turned ? facet.reversed() : facet;
}

/// Moves listed facets that lie between two cells to the inner ones, and turns the others outwards.
/// returns  which of the table's sides are listed
template <int Dim>
std::vector<bool> sort_listed_facets(MixedMesh<Dim>& mesh, const MixedSides<Dim>& sides, bool take_inner) {
  std::vector<bool> listed(sides.entries().size(), false);
  std::vector<MarkedMixedFacet<Dim>> boundary;
  boundary.reserve(mesh.boundary.size());
  for (auto& facet : mesh.boundary) {
    const auto [ring, turned] = directed_ring(facet.corners);
    const auto group = sides.find(ring);
    if (group.size() == 2 && take_inner) {
      mesh.inner_facets.push_back(facet);
      continue;
    }
    if (group.size() == 1) {
      listed[sides.number_of(group[0])] = true;
      if (group[0].turned != turned) facet.corners = facet.corners.reversed();
    }
    boundary.push_back(facet);
  }
  mesh.boundary = std::move(boundary);
  return listed;
}

template <int Dim>
void add_unlisted_facets(MixedMesh<Dim>& mesh, const MixedSides<Dim>& sides, const std::vector<bool>& listed,
                         Marker marker) {
  sides.for_each_facet_until([&](auto group) {
    if (group.size() == 1 && !listed[sides.number_of(group[0])])
      mesh.boundary.push_back({outward(group[0]), marker});
    return false;
  });
}

/// What can be said without facets.
template <int Dim>
void refuse_broken_cells(const MixedMesh<Dim>& mesh, const std::string& source) {
  const std::string remedy = "correct the cell's vertices";
  refuse(broken_sizes(mesh), source, "give one entry each");
  refuse(broken_kind(mesh), source, remedy);
  refuse(corner_out_of_range(mesh), source, remedy);
  refuse(broken_point(mesh), source, "correct its coordinates");
  refuse(repeated_corner(mesh), source, "correct its vertices");
  refuse(unused_vertex(mesh), source, "remove the vertex or restore the cells about it");
  refuse(broken_orientation(mesh), source, "correct the order of its vertices, or their coordinates");
}

}  // namespace

template <int Dim>
std::vector<MarkedMixedFacet<Dim>> boundary_facets(const MixedMesh<Dim>& mesh, Marker marker) {
  const std::string remedy = "correct the list of cells";
  require_ids_in_range(mesh);
  refuse(repeated_corner(mesh), "mesh", remedy);
  const MixedSides<Dim> sides(mesh);
  refuse(broken_facet(mesh, sides), "mesh", remedy);
  std::vector<MarkedMixedFacet<Dim>> facets;
  sides.for_each_facet_until([&](auto group) {
    if (group.size() == 1) facets.push_back({outward(group[0]), marker});
    return false;
  });
  return facets;
}

template <int Dim>
std::vector<std::array<CellId, 2>> neighbouring_cells(const MixedMesh<Dim>& mesh) {
  const std::string remedy = "correct the list of cells";
  require_ids_in_range(mesh);
  refuse(repeated_corner(mesh), "mesh", remedy);
  const MixedSides<Dim> sides(mesh);
  refuse(broken_facet(mesh, sides), "mesh", remedy);
  std::vector<std::array<CellId, 2>> pairs;
  sides.for_each_facet_until([&](auto group) {
    if (group.size() == 2) pairs.push_back({group[0].cell, group[1].cell});
    return false;
  });
  return pairs;
}

template <int Dim>
MixedMesh<Dim> make_mixed_mesh(MixedMesh<Dim> mesh, const std::string& source,
                               const MarkedFacetRules& rules) {
  if (mesh.regions.empty()) mesh.regions.resize(mesh.cell_count(), 0.0);
  if (mesh.vertex_markers.empty()) mesh.vertex_markers.resize(mesh.vertex_count(), 0);
  refuse_broken_cells(mesh, source);
  const MixedSides<Dim> sides(mesh);
  refuse(broken_facet(mesh, sides), source, "correct the list of cells");
  if constexpr (Dim == 3)
    refuse(unconforming_face(mesh, sides), source,
           "split the face in both cells alike, or put a pyramid between them");
  const std::vector<bool> listed = sort_listed_facets(mesh, sides, rules.take_inner_facets);
  if (rules.unlisted_boundary) add_unlisted_facets(mesh, sides, listed, *rules.unlisted_boundary);
  const std::string facet = Simplex<Dim>::facet;
  refuse(broken_boundary(mesh, sides), source,
         "every boundary " + facet + " needs exactly one marker; if the " + facet +
             " should not be on the boundary, a cell is missing or two vertices stand for one");
  refuse(broken_inner_facet(mesh, sides), source, "remove it from the list");
  return mesh;
}

template std::vector<MarkedMixedFacet<2>> boundary_facets(const MixedMesh<2>&, Marker);
template std::vector<MarkedMixedFacet<3>> boundary_facets(const MixedMesh<3>&, Marker);
template std::vector<std::array<CellId, 2>> neighbouring_cells(const MixedMesh<2>&);
template std::vector<std::array<CellId, 2>> neighbouring_cells(const MixedMesh<3>&);
template MixedMesh<2> make_mixed_mesh(MixedMesh<2>, const std::string&, const MarkedFacetRules&);
template MixedMesh<3> make_mixed_mesh(MixedMesh<3>, const std::string&, const MarkedFacetRules&);

}  // namespace leonhard::mesh
