// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::io {

/// A tetrahedron as a file states it: nothing about it is known to be right.
struct TetCell {
  std::array<VertexId, 4> corners;
  std::uint32_t line = 0;  ///< of the file; 0: the file has no lines
};

/// A marked triangle as a file states it.
struct TetFace {
  std::array<VertexId, 3> corners;
  Marker marker{};
  std::uint32_t line = 0;  ///< of the file; 0: the file has no lines
};

/// What a tetrahedral mesh file states, before anything is checked.
struct TetSoup {
  PerId<VertexId, Point3> points;
  std::vector<TetCell> cells;
  std::vector<TetFace> faces;  ///< of the boundary or between two cells, in either direction; see FaceRule
  std::vector<double> cell_regions;    ///< one a cell, or empty
  std::vector<Marker> vertex_markers;  ///< one a vertex, or empty
  std::map<Marker, std::string> marker_names;
  std::vector<PointField> point_fields;  ///< one row a vertex
  std::vector<CellField> cell_fields;    ///< one row a cell
  std::vector<std::string> warnings;     ///< what the result's begin with
  std::string source;                    ///< names the file in errors
  std::string note;                      ///< added to errors, e.g. that ids in them are numbered from 0
};

/// What the listed faces of a soup are.
enum class FaceRule {
  /// Every face of the boundary is listed and no other.
  faces_are_the_boundary,
  /// Every face of the boundary is listed; the others are interfaces, whatever their marker.
  boundary_and_interfaces,
  /// Inner faces are interfaces, or left out if their marker is 0; unlisted boundary faces get a marker.
  fill_in_the_boundary
};

/// Make the mesh that a file states, or say why it is none.
///
/// Tetrahedra that are all negative are turned over. Under fill_in_the_boundary an unlisted boundary face gets the marker
/// that its three vertices share if it is not 0, else the smallest positive number that neither a listed face nor a name
/// has. The warnings tell each of these.
///
/// throws InputError naming line, ids and coordinates: id out of range, a tetrahedron of no volume or given twice,
/// tetrahedra of unlike orientation, a face given twice, and all that make_tet_mesh and validate_embedding refuse
/// Cost O(cells + boundary log boundary).
[[nodiscard]] TetMeshFile assemble(TetSoup soup, FaceRule rule);

}  // namespace leonhard::io
