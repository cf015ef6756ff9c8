// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// Fill mesh.neighbours from mesh.corners: neighbours[t][i] is the cell across the facet opposite corners[t][i], none on
/// the boundary. Coordinates, markers, boundary and inner facets are not read.
///
/// throws  InputError, mesh unchanged, on a corner that is no vertex, a cell that names a vertex twice, a facet with
///         three cells, two on the same side (neighbours of unlike orientation), and a cell given twice; names the cells
/// Cost O(vertices + cells), one sort by buckets.
template <int Dim>
void build_neighbours(SimplexMesh<Dim>& mesh);

/// The boundary as mesh.neighbours has it: each facet without a cell behind, directed outwards and its smallest vertex
/// first (of a face; an edge has the mesh to its left), sorted by vertices in ascending order.
///
/// marker  of all of them
/// throws  InputError for an id out of range or an array of the wrong size
/// Cost O(cells + boundary log boundary).
template <int Dim>
[[nodiscard]] std::vector<typename Simplex<Dim>::MarkedFacet> boundary_facets(const SimplexMesh<Dim>& mesh,
                                                                              Marker marker = 1);

/// What make_triangle_mesh and make_tet_mesh do with lists of marked facets that are not just the boundary. Without rules
/// every boundary facet has to be listed, and no other.
struct MarkedFacetRules {
  /// Boundary facets that are not listed get this marker and follow those listed, in the order of boundary_facets. None:
  /// they are refused. (TetGen's files may list none at all.)
  std::optional<Marker> unlisted_boundary{};
  /// Facets listed that lie between two cells become the mesh's inner facets (constraints, interfaces), as given and in
  /// the order given. False: they are refused.
  bool take_inner_facets = false;
};

/// A checked mesh of triangles (Dim = 2) or tetrahedra (Dim = 3) from what a file or a generator holds. `mesh::validate`
/// finds nothing wrong with the result.
///
/// points   one a vertex, finite
/// corners  vertices of each cell, positive by exact orient2d (counter-clockwise) or orient3d
/// facets   every boundary facet once, in either direction; the result has them in the same order, directed outwards.
///          Others as `rules` allow
/// names    names of markers; markers need no name
/// source   file or description that errors name as their place; may be empty
/// returns  the mesh; vertex_markers and regions are 0: the caller may fill them
/// throws   InputError naming ids and coordinates: a number that is not finite, a corner out of range or repeated, a cell
///          of zero or negative area or volume, a facet of three cells, two on the same side of one, a boundary facet
///          marked twice or never, a marked facet that is none of the boundary's, a vertex of no cell
/// Overlaps that no single cell shows are the business of `mesh::validate_embedding`.
/// Cost O(vertices + cells + boundary log boundary).
template <int Dim>
[[nodiscard]] SimplexMesh<Dim> make_mesh(
    PerId<VertexId, typename Simplex<Dim>::Point> points,
    PerId<typename Simplex<Dim>::CellId, typename SimplexMesh<Dim>::CellCorners> corners,
    std::vector<typename Simplex<Dim>::MarkedFacet> facets, std::map<Marker, std::string> names = {},
    const std::string& source = {}, const MarkedFacetRules& rules = {});

/// make_mesh of triangles: `boundary` holds its edges.
[[nodiscard]] inline TriangleMesh make_triangle_mesh(PerId<VertexId, Point2> points,
                                                     PerId<TriangleId, std::array<VertexId, 3>> corners,
                                                     std::vector<MarkedEdge> boundary,
                                                     std::map<Marker, std::string> names = {},
                                                     const std::string& source = {},
                                                     const MarkedFacetRules& rules = {}) {
  return make_mesh<2>(std::move(points), std::move(corners), std::move(boundary), std::move(names), source,
                      rules);
}

/// make_mesh of tetrahedra: `boundary` holds its faces.
[[nodiscard]] inline TetMesh make_tet_mesh(PerId<VertexId, Point3> points,
                                           PerId<TetId, std::array<VertexId, 4>> corners,
                                           std::vector<MarkedFace> boundary,
                                           std::map<Marker, std::string> names = {},
                                           const std::string& source = {},
                                           const MarkedFacetRules& rules = {}) {
  return make_mesh<3>(std::move(points), std::move(corners), std::move(boundary), std::move(names), source,
                      rules);
}

}  // namespace leonhard::mesh
