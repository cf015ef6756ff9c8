// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/tet_mesh_file.hpp"

namespace leonhard::io {

enum class GmshVersion { v2_2, v4_1 };

/// The form in which a .msh file is written.
struct GmshForm {
  GmshVersion version = GmshVersion::v4_1;
  bool binary = false;  ///< in this machine's byte order; else text
};

/// Read a tetrahedral mesh of Gmsh (https://gmsh.info/doc/texinfo/gmsh.html, "Gmsh file formats"), version 2.2 or 4.1,
/// text or binary of either byte order. Physical groups of triangles are the markers, those of tetrahedra the regions;
/// names of groups of surfaces are the markers' names. Points and lines are left out; so are nodes that no cell uses, and
/// data, with a warning.
///
/// A boundary face that is not listed gets a marker (see mesh_soup.hpp), listed inner faces in a group are interfaces.
/// Vertices are numbered in the order of the file's nodes, whatever their tags.
///
/// throws InputError: another version, a partitioned mesh, other cells than triangles and tetrahedra of first order (by
/// name), and as read_tet_mesh
[[nodiscard]] TetMeshFile read_tet_gmsh(const std::filesystem::path& path);
[[nodiscard]] TetMeshFile parse_tet_gmsh(std::string_view bytes, const std::string& source);

/// Read a triangle mesh of Gmsh in a plane z = const: groups of lines are the markers, those of triangles and
/// quadrilaterals (which are split) the regions. Boundary edges that are not listed get a marker (see mesh_soup.hpp).
/// throws InputError: as read_tet_gmsh and read_mesh; points off the plane
[[nodiscard]] MeshFile read_gmsh(const std::filesystem::path& path);
[[nodiscard]] MeshFile parse_gmsh(std::string_view bytes, const std::string& source);

/// Write a mesh so that it comes back: points to the last bit, cells and their order, markers, names and regions. The
/// format has no place for the vertices' markers.
///
/// throws InputError if a marker is negative (Gmsh takes the sign for a direction), a region is no whole number from 0
/// to 2^31 - 1, or a name holds a quotation mark or a control character; OutputError
void write_gmsh(const std::filesystem::path& path, const TetMesh& mesh, const GmshForm& form = {});
void write_gmsh(const std::filesystem::path& path, const TriangleMesh& mesh, const GmshForm& form = {});

/// The bytes that write_gmsh writes.
[[nodiscard]] std::string format_gmsh(const TetMesh& mesh, const GmshForm& form = {});
[[nodiscard]] std::string format_gmsh(const TriangleMesh& mesh, const GmshForm& form = {});

}  // namespace leonhard::io
