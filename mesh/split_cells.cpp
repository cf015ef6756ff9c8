// SPDX-License-Identifier: MIT
#include "leonhard/mesh/split_cells.hpp"

#include <algorithm>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::mesh {
namespace {

/// Calls visit(simplex) for the parts of a facet, cut from its smallest vertex, in its direction.
template <class Visit>
void for_each_part(const MixedFacet<2>& edge, Visit visit) {
  visit(std::array<VertexId, 2>{edge[0], edge[1]});
}
template <class Visit>
void for_each_part(const MixedFacet<3>& face, Visit visit) {
  const auto smallest = static_cast<std::size_t>(std::min_element(face.begin(), face.end()) - face.begin());
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    visit(std::array<VertexId, 3>{face[smallest], face[(smallest + i) % face.size()],
                                  face[(smallest + i + 1) % face.size()]});
}

/// The simplex on a part of a facet, which is directed away from the apex.
std::array<VertexId, 3> simplex_of(const std::array<VertexId, 2>& edge, VertexId apex) {
  return {edge[0], edge[1], apex};
}
std::array<VertexId, 4> simplex_of(const std::array<VertexId, 3>& face, VertexId apex) {
  return {face[0], face[2], face[1], apex};
}

Sign sign_of_part(const MixedMesh<2>& mesh, const std::array<VertexId, 3>& c) {
  return kernel::orient2d(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]);
}
Sign sign_of_part(const MixedMesh<3>& mesh, const std::array<VertexId, 4>& c) {
  return kernel::orient3d(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]], mesh.points[c[3]]);
}

template <int Dim>
void split_one(const MixedMesh<Dim>& mesh, CellId cell, SplitMesh<Dim>& split) {
  const auto corners = mesh.corners_of(cell);
  const VertexId apex = *std::min_element(corners.begin(), corners.end());
  for (std::size_t side = 0; side < mesh.shape(cell).facets.size(); ++side) {
    const MixedFacet<Dim> facet = mesh.facet_of(cell, side);
    if (std::find(facet.begin(), facet.end(), apex) != facet.end()) continue;
    for_each_part(facet, [&](const auto& part) {
      const auto simplex = simplex_of(part, apex);
      if (sign_of_part(mesh, simplex) != Sign::positive)
        throw InputError("mesh",
                         words(mesh, cell) + " cannot be cut from " + words(mesh, apex) + ": the part at " +
                             words(mesh, facet) + " is not positive",
                         "its faces bend too much");
      split.mesh.corners.push_back(simplex);
      split.mesh.regions.push_back(mesh.regions[cell]);
      split.cell_of.push_back(cell);
    });
  }
}

template <int Dim>
std::vector<typename Simplex<Dim>::MarkedFacet> split_facets(
    const std::vector<MarkedMixedFacet<Dim>>& facets) {
  std::vector<typename Simplex<Dim>::MarkedFacet> parts;
  for (const auto& facet : facets)
    for_each_part(facet.corners,
                  [&](const auto& part) { parts.push_back(Simplex<Dim>::marked(part, facet.marker)); });
  return parts;
}

}  // namespace

template <int Dim>
SplitMesh<Dim> split_cells(const MixedMesh<Dim>& mesh) {
  require_ids_in_range(mesh);
  SplitMesh<Dim> split;
  split.mesh.points = mesh.points;
  split.mesh.vertex_markers = mesh.vertex_markers;
  split.mesh.marker_names = mesh.marker_names;
  split.mesh.region_names = mesh.region_names;
  for (const CellId cell : mesh.kinds.ids()) split_one(mesh, cell, split);
  split.mesh.boundary = split_facets(mesh.boundary);
  split.mesh.inner_facets() = split_facets(mesh.inner_facets);
  build_neighbours(split.mesh);
  return split;
}

template SplitMesh<2> split_cells(const MixedMesh<2>&);
template SplitMesh<3> split_cells(const MixedMesh<3>&);

}  // namespace leonhard::mesh
