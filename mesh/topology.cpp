// SPDX-License-Identifier: MIT
#include "leonhard/mesh/topology.hpp"

#include <cstddef>

#include "leonhard/mesh/check/invariants.hpp"
#include "leonhard/mesh/ids_in_range.hpp"

namespace leonhard::mesh {
namespace {

/// Moves facets that are no boundary facets but lie between two cells to the inner facets.
template <int Dim>
void take_inner_facets(SimplexMesh<Dim>& mesh, const BoundaryFacets<Dim>& boundary,
                       const HalfFacetTable<Dim>& table) {
  std::vector<typename Simplex<Dim>::MarkedFacet> rest;
  rest.reserve(mesh.boundary.size());
  for (const auto& facet : mesh.boundary) {
    const auto ascending = sorted_facet(Simplex<Dim>::corners_of(facet)).corners;
    const bool is_inner = !boundary.find(ascending) && table.find(ascending).size() == 2;
    (is_inner ? mesh.inner_facets() : rest).push_back(facet);
  }
  mesh.boundary = std::move(rest);
}

/// Turns listed boundary facets outwards; those that are no boundary facets stay as they are.
/// returns  which of boundary.facets() are listed
template <int Dim>
std::vector<bool> turn_outwards(SimplexMesh<Dim>& mesh, const BoundaryFacets<Dim>& boundary) {
  std::vector<bool> listed(boundary.facets().size(), false);
  for (auto& facet : mesh.boundary) {
    auto corners = Simplex<Dim>::corners_of(facet);
    const SortedFacet<Dim> sorted = sorted_facet(corners);
    const auto at = boundary.find(sorted.corners);
    if (!at) continue;
    listed[*at] = true;
    if (boundary.facets()[*at].sorted.even == sorted.even) continue;
    std::swap(corners[Dim - 2], corners[Dim - 1]);
    facet = Simplex<Dim>::marked(corners, facet.marker);
  }
  return listed;
}

template <int Dim>
void add_unlisted(SimplexMesh<Dim>& mesh, const BoundaryFacets<Dim>& boundary,
                  const std::vector<bool>& listed, Marker marker) {
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (!listed[i])
      mesh.boundary.push_back(Simplex<Dim>::marked(boundary.facets()[i].sorted.directed(), marker));
  }
}

constexpr const char* turn_remedy(const TriangleMesh&) {
  return "list its vertices counter-clockwise, or move one so that it has an area";
}
constexpr const char* turn_remedy(const TetMesh&) {
  return "list its vertices so that the fourth lies where the first three turn counter-clockwise, or move "
         "one "
         "so that it has a volume";
}

}  // namespace

template <int Dim>
void build_neighbours(SimplexMesh<Dim>& mesh) {
  mesh.neighbours = neighbours_of(mesh, checked_half_facets(mesh));
}

template <int Dim>
std::vector<typename Simplex<Dim>::MarkedFacet> boundary_facets(const SimplexMesh<Dim>& mesh, Marker marker) {
  require_ids_in_range(mesh);
  const BoundaryFacets<Dim> boundary(mesh);
  std::vector<typename Simplex<Dim>::MarkedFacet> facets;
  facets.reserve(boundary.facets().size());
  for (const auto& facet : boundary.facets())
    facets.push_back(Simplex<Dim>::marked(facet.sorted.directed(), marker));
  return facets;
}

template <int Dim>
SimplexMesh<Dim> make_mesh(
    PerId<VertexId, typename Simplex<Dim>::Point> points,
    PerId<typename Simplex<Dim>::CellId, typename SimplexMesh<Dim>::CellCorners> corners,
    std::vector<typename Simplex<Dim>::MarkedFacet> facets, std::map<Marker, std::string> names,
    const std::string& source, const MarkedFacetRules& rules) {
  const std::string cell = Simplex<Dim>::cell, cells = Simplex<Dim>::cells, facet = Simplex<Dim>::facet;
  SimplexMesh<Dim> mesh;
  mesh.points = std::move(points);
  mesh.corners = std::move(corners);
  mesh.boundary = std::move(facets);
  mesh.marker_names = std::move(names);
  mesh.vertex_markers.resize(mesh.vertex_count(), 0);
  mesh.regions.resize(mesh.cell_count(), 0.0);

  refuse(broken_point(mesh), source, "correct its coordinates");
  refuse(broken_corner(mesh), source, "correct the " + cell + "'s vertices");
  refuse(unused_vertex(mesh), source, "remove the vertex or restore the " + cells + " about it");
  refuse(broken_orientation(mesh), source, turn_remedy(mesh));
  const HalfFacetTable<Dim> table = checked_half_facets(mesh, source);
  mesh.neighbours = neighbours_of(mesh, table);

  const BoundaryFacets<Dim> boundary(mesh);
  if (rules.take_inner_facets) take_inner_facets(mesh, boundary, table);
  const std::vector<bool> listed = turn_outwards(mesh, boundary);
  if (rules.unlisted_boundary) add_unlisted(mesh, boundary, listed, *rules.unlisted_boundary);
  refuse(broken_boundary(mesh, boundary), source,
         "every boundary " + facet + " needs exactly one marker; if the " + facet +
             " should not be on the boundary, a " + cell + " is missing or two vertices stand for one");
  return mesh;
}

template void build_neighbours(SimplexMesh<2>&);
template void build_neighbours(SimplexMesh<3>&);
template std::vector<MarkedEdge> boundary_facets(const SimplexMesh<2>&, Marker);
template std::vector<MarkedFace> boundary_facets(const SimplexMesh<3>&, Marker);
template TriangleMesh make_mesh<2>(PerId<VertexId, Point2>, PerId<TriangleId, std::array<VertexId, 3>>,
                                   std::vector<MarkedEdge>, std::map<Marker, std::string>, const std::string&,
                                   const MarkedFacetRules&);
template TetMesh make_mesh<3>(PerId<VertexId, Point3>, PerId<TetId, std::array<VertexId, 4>>,
                              std::vector<MarkedFace>, std::map<Marker, std::string>, const std::string&,
                              const MarkedFacetRules&);

}  // namespace leonhard::mesh
