// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard::io {

/// Read a tetrahedral mesh in Medit's text format (P. Frey, INRIA RT-0253, 2001): Vertices, Tetrahedra and Triangles with
/// their references, which are the vertices' markers, the regions, and the markers of faces; sections in any order,
/// # starts a comment. Sections of edges, corners, normals and the like are passed over with a warning.
///
/// A boundary face that is not listed gets a marker (see mesh_soup.hpp), listed inner faces with a reference other than 0
/// are interfaces. Ids are the file's numbers less 1.
///
/// throws InputError: a file of the plane, other cells than triangles and tetrahedra, and as read_tet_mesh
[[nodiscard]] TetMeshFile read_medit(const std::filesystem::path& path);

/// The same from text in memory; source names it in errors.
[[nodiscard]] TetMeshFile parse_medit(std::string_view text, const std::string& source);

/// The text from which a mesh is read again: cells by kinds, names of markers and regions included (as leading comments
/// "# marker 2 farfield"). Of the plane edges are the facets, triangles and quadrilaterals the cells.
///
/// throws InputError if a region is no whole number of 32 bits, or if a name cannot stand in a comment
[[nodiscard]] std::string format_medit(const TetMesh& mesh);
[[nodiscard]] std::string format_medit(const TriangleMesh& mesh);
[[nodiscard]] std::string format_medit(const MixedMesh<2>& mesh);
[[nodiscard]] std::string format_medit(const MixedMesh<3>& mesh);

}  // namespace leonhard::io
