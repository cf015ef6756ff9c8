// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"

namespace leonhard::io {

/// A triangle, quadrilateral or tetrahedron as a file states it: nothing about it is known to be right.
struct SoupCell {
  std::array<VertexId, 4> corners;
  std::uint32_t corner_count;  ///< 3 or 4, in space 4
  std::uint32_t line = 0;      ///< of the file; 0: the file has no lines
};

/// A marked edge (Dim = 2) or face (Dim = 3) as a file states it.
template <int Dim>
struct SoupFacet {
  std::array<VertexId, Dim> corners;
  Marker marker{};
  std::uint32_t line = 0;  ///< of the file; 0: the file has no lines
};

/// What a mesh file states, before anything is checked.
template <int Dim>
struct MeshSoup {
  PerId<VertexId, typename Simplex<Dim>::Point> points;
  std::vector<SoupCell> cells;
  std::vector<SoupFacet<Dim>>
      facets;  ///< of the boundary or between two cells, in either direction; see FacetRule
  std::vector<double> cell_regions;    ///< one a cell, or empty
  std::vector<Marker> vertex_markers;  ///< one a vertex, or empty
  std::map<Marker, std::string> marker_names;
  std::vector<PointField> point_fields;  ///< one row a vertex
  std::vector<CellField> cell_fields;    ///< one row a cell
  std::vector<std::string> warnings;     ///< what the result's begin with
  std::string source;                    ///< names the file in errors
  std::string note;                      ///< added to errors, e.g. that ids in them are numbered from 0
};

/// What the listed facets of a soup are.
enum class FacetRule {
  /// Every facet of the boundary is listed and no other.
  facets_are_the_boundary,
  /// Every facet of the boundary is listed; the others are inner facets, whatever their marker.
  boundary_and_inner_facets,
  /// Listed inner facets are those of the mesh, but for faces whose marker is 0; unlisted boundary facets get a marker.
  fill_in_the_boundary
};

/// Make the mesh that a file states, or say why it is none.
///
/// Triangles that are all clockwise are turned over, and so are quadrilaterals and tetrahedra; quadrilaterals are split
/// along their Delaunay diagonal (exact, ties by kernel::incircle_perturbed), where that gives two positive triangles,
/// else along the other. Under fill_in_the_boundary an unlisted boundary facet gets the marker that its vertices share if
/// it is not 0; else an edge gets 1, a face the smallest positive number that neither a listed face nor a name has. The
/// warnings tell each of these.
///
/// throws InputError naming line, ids and coordinates: id out of range, a cell of zero area or volume or tangled, cells of
/// unlike orientation, a face given twice, and all that make_mesh and validate_embedding refuse
/// Cost O(cells + boundary log boundary).
template <int Dim>
[[nodiscard]] SimplexMeshFile<Dim> assemble(MeshSoup<Dim> soup, FacetRule rule);

}  // namespace leonhard::io
