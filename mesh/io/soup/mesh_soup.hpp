// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "leonhard/mesh/io/read_options.hpp"

namespace leonhard::io {

/// What a mesh file states, cells of any kind, before anything but the kinds is checked.
template <int Dim>
struct MeshSoup {
  /// Corners may be out of range; boundary has all facets that the file lists, of the boundary or between two cells, in
  /// either direction; vertex_markers and regions may be empty.
  MixedMesh<Dim> mesh;
  std::vector<std::uint32_t> cell_lines;   ///< of the file, one a cell; empty: the file has no lines
  std::vector<std::uint32_t> facet_lines;  ///< likewise, one a facet
  bool prisms_turn_either_way = false;     ///< no warning where all are turned over: programs differ
  bool facets_as_they_are =
      false;  ///< repeated facets stay, and so do inner faces whose marker is 0: our own file
  std::vector<PointField> point_fields;  ///< one row a vertex
  std::vector<CellField> cell_fields;    ///< one row a cell
  std::vector<std::string> warnings;     ///< what the result's begin with
  std::string source;                    ///< names the file in errors
  std::string note;                      ///< added to errors, e.g. that ids in them are numbered from 0

  /// Both lines of a cell or facet with lines.
  CellId add_cell(CellKind kind, std::span<const VertexId> corners, std::size_t line) {
    cell_lines.push_back(static_cast<std::uint32_t>(line));
    return mesh.add_cell(kind, corners);
  }
  void add_facet(std::span<const VertexId> corners, Marker marker, std::size_t line) {
    facet_lines.push_back(static_cast<std::uint32_t>(line));
    mesh.boundary.push_back({MixedFacet<Dim>(corners), marker});
  }
};

using AnySoup = std::variant<MeshSoup<2>, MeshSoup<3>>;

/// The name of the marker that boundary facets get which have none in their file.
inline constexpr const char* unmarked = "unmarked";

/// Make the mesh that a file states, or say why it is none. One rule for all formats, and the warnings tell each of these:
/// - vertices closer than options.weld become one;
/// - vertices that no cell uses are dropped;
/// - cells that are turned over are turned back, each by itself: what then overlaps is found by exact tests;
/// - a facet listed twice with one marker counts once;
/// - listed facets between two cells are inner facets, but for faces of space whose marker is 0;
/// - an unlisted boundary facet gets the marker that its vertices share if it is not 0, else that of the name `unmarked`: the
///   smallest positive number that neither a listed facet nor a name has;
/// - boundary facets that lie back to back on vertices of equal places are left so, with a hint.
///
/// throws InputError naming line, ids and coordinates: id out of range, a cell that is flat or tangled, a facet given twice
/// with two markers, a listed facet that is no side of a cell, and all that make_mixed_mesh and, in the plane,
/// validate_embedding refuse
/// Cost O(cells log degree + boundary log boundary).
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> assemble_mixed(MeshSoup<Dim> soup, const ReadOptions& options = {});

/// The same for triangles and tetrahedra alone, which validate_embedding checks in space too. Quadrilaterals are split along
/// their Delaunay diagonal (exact, ties by kernel::incircle_perturbed), where that gives two positive triangles, else along
/// the other; both halves get the quadrilateral's region and fields. Other cells of space are split if options say so.
///
/// throws InputError as assemble_mixed and make_mesh; hexahedra, prisms and pyramids without options.split
template <int Dim>
[[nodiscard]] SimplexMeshFile<Dim> assemble_simplices(MeshSoup<Dim> soup, const ReadOptions& options = {});

}  // namespace leonhard::io
