// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"

namespace leonhard::io {

/// What a file of mixed cells states, before anything but the kinds is checked.
template <int Dim>
struct MixedSoup {
  /// Corners may be out of range; boundary has all facets that the file lists, in either direction; vertex_markers and
  /// regions may be empty.
  MixedMesh<Dim> mesh;
  std::vector<std::uint32_t> cell_lines;   ///< of the file, one a cell; empty: the file has no lines
  std::vector<std::uint32_t> facet_lines;  ///< likewise, one a facet
  bool prisms_turn_either_way = false;     ///< no warning where all are turned over: programs differ
  std::vector<PointField> point_fields;    ///< one row a vertex
  std::vector<CellField> cell_fields;      ///< one row a cell
  std::vector<std::string> warnings;       ///< what the result's begin with
  std::string source;                      ///< names the file in errors
  std::string note;                        ///< added to errors, e.g. that ids in them are numbered from 0
};

/// Make the mesh that a file states, or say why it is none.
///
/// Cells of one kind that are all turned over are turned back. Under fill_in_the_boundary an unlisted boundary facet gets
/// the marker that its vertices share if it is not 0, else the smallest positive number that neither a listed facet nor a
/// name has. The warnings tell both.
///
/// throws InputError naming line, ids and coordinates: id out of range, a cell that is flat or tangled, cells of a kind of
/// unlike orientation, a facet given twice, and all that make_mixed_mesh and, in the plane, validate_embedding refuse
/// Cost O(cells log degree + boundary log boundary).
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> assemble(MixedSoup<Dim> soup, FacetRule rule);

}  // namespace leonhard::io
