// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"

namespace leonhard::io {

/// Read a 2-D mesh in SU2's native format (https://su2code.github.io/docs_v7/Mesh-File/): NDIME, NELEM with
/// cells of type 5 (triangle) and 9 (quadrilateral), NPOIN, NMARK with MARKER_TAG and MARKER_ELEMS of type 3
/// (line), in any order; % starts a comment; trailing element and point numbers are optional.
///
/// Ids are the file's 0-based ones. Markers get the numbers 1, 2, ... in the file's order (or those that
/// write_su2 noted in a leading comment). A quadrilateral is split along its Delaunay diagonal, so triangle
/// ids then differ from cell numbers. Points may have a constant third coordinate; markers SEND_RECEIVE and elements of
/// single vertices are passed over. All else that is mended see mesh_soup.hpp; the warnings tell it.
///
/// throws InputError: 3-D file, several zones, unknown cell type, id out of range, zero-area or overlapping cells,
/// marked edges that are no sides of cells, two markers of one name, NaN, file cut short
/// Cost O(file size + cells log cells).
[[nodiscard]] MeshFile read_su2(const std::filesystem::path& path);

/// The same from text in memory; source names it in errors.
[[nodiscard]] MeshFile parse_su2(std::string_view text, const std::string& source);

/// Write a mesh so that read_su2 gives it back: points to the last bit, triangles, boundary, marker numbers
/// and names. The format has no place for vertex markers, regions and interior constraints. A marker without
/// a name is written as marker_<number>.
///
/// throws InputError if two boundary markers share a name or a name cannot stand in the file (empty, blanks,
/// %), OutputError if the file cannot be written
void write_su2(const std::filesystem::path& path, const TriangleMesh& mesh);

/// The text that write_su2 writes.
[[nodiscard]] std::string format_su2(const TriangleMesh& mesh);

/// The same for tetrahedral meshes: NDIME= 3, cells of type 10, markers with elements of type 5 (triangle).
///
/// throws InputError: as read_su2; cells other than tetrahedra, and as read_tet_mesh
[[nodiscard]] TetMeshFile read_tet_su2(const std::filesystem::path& path);
[[nodiscard]] TetMeshFile parse_tet_su2(std::string_view text, const std::string& source);

/// The format has no place for vertex markers, regions and interfaces. throws as write_su2 of triangles
void write_su2(const std::filesystem::path& path, const TetMesh& mesh);
[[nodiscard]] std::string format_su2(const TetMesh& mesh);

/// The same for meshes of mixed cells, quadrilaterals left whole: cells of type 5 (triangle) and 9 (quadrilateral), markers of
/// type 3 (line) in the plane; cells of type 10 (tetrahedron), 12 (hexahedron), 13 (prism) and 14 (pyramid), markers of
/// type 5 and 9 in space. Ids are the file's. Corners come in the order of CellKind.
///
/// throws  InputError as read_su2 and read_mixed_mesh do
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> read_mixed_su2(const std::filesystem::path& path);
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> parse_mixed_su2(std::string_view text, const std::string& source);

/// The format has no place for vertex markers, regions and inner facets. throws as write_su2 of triangles
void write_su2(const std::filesystem::path& path, const MixedMesh<2>& mesh);
void write_su2(const std::filesystem::path& path, const MixedMesh<3>& mesh);
[[nodiscard]] std::string format_su2(const MixedMesh<2>& mesh);
[[nodiscard]] std::string format_su2(const MixedMesh<3>& mesh);

}  // namespace leonhard::io
