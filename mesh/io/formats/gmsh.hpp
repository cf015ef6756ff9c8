// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/formats/gmsh_form.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"

namespace leonhard::io {

/// Read a tetrahedral mesh of Gmsh (https://gmsh.info/doc/texinfo/gmsh.html, "Gmsh file formats"), version 1, 2, 4.0 or 4.1,
/// text or binary of either byte order. Physical groups of triangles are the markers, those of tetrahedra the regions, names
/// included (see parse_gmsh_data). Points and lines are left out. $NodeData and $ElementData come as fields where every vertex or tetrahedron has a value, the first of each
/// name; others, and other data, are left out with a warning.
///
/// A boundary face that is not listed gets a marker (see mesh_soup.hpp), listed inner faces in a group are interfaces.
/// Vertices are numbered in the order of the file's nodes, whatever their tags.
///
/// throws InputError: another version, other cells than tetrahedra, and as read_tet_mesh
[[nodiscard]] TetMeshFile read_tet_gmsh(const std::filesystem::path& path);
[[nodiscard]] TetMeshFile parse_tet_gmsh(std::string_view bytes, const std::string& source);

/// Read a triangle mesh of Gmsh in a plane z = const: groups of lines are the markers, those of triangles and
/// quadrilaterals (which are split) the regions. Boundary edges that are not listed get a marker (see mesh_soup.hpp).
/// throws InputError: as read_tet_gmsh and read_mesh; points off the plane
[[nodiscard]] MeshFile read_gmsh(const std::filesystem::path& path);
[[nodiscard]] MeshFile parse_gmsh(std::string_view bytes, const std::string& source);

/// Write a mesh so that it comes back: points to the last bit, cells and their order, markers, names, regions, and fields
/// ($NodeData and $ElementData). Every element is in a physical group, those of marker or region 0 in one of a name that says
/// so, since Gmsh drops elements in none when it saves. The format has no place for the vertices' markers. Gmsh knows 1, 3 and 9 components of a
/// field; two are written as three with a zero, and come back as three.
///
/// throws InputError if a marker is negative (Gmsh takes the sign for a direction), a region is no whole number from 0
/// to 2^31 - 1, a name holds a quotation mark or a control character, or a field does not fit the mesh or has another
/// number of components; OutputError
void write_gmsh(const std::filesystem::path& path, const TetMesh& mesh, const GmshForm& form = {},
                const std::vector<PointField>& point_fields = {},
                const std::vector<CellField>& cell_fields = {});
void write_gmsh(const std::filesystem::path& path, const TriangleMesh& mesh, const GmshForm& form = {},
                const std::vector<PointField>& point_fields = {},
                const std::vector<CellField>& cell_fields = {});

/// The bytes that write_gmsh writes.
[[nodiscard]] std::string format_gmsh(const TetMesh& mesh, const GmshForm& form = {},
                                      const std::vector<PointField>& point_fields = {},
                                      const std::vector<CellField>& cell_fields = {});
[[nodiscard]] std::string format_gmsh(const TriangleMesh& mesh, const GmshForm& form = {},
                                      const std::vector<PointField>& point_fields = {},
                                      const std::vector<CellField>& cell_fields = {});

/// The same for meshes of mixed cells, quadrilaterals left whole: groups of lines (of the plane) or of triangles and
/// quadrilaterals (of space) are the markers, those of cells the regions. Cells come in the order of their numbers.
///
/// throws InputError: as read_tet_gmsh and read_mixed_mesh
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> read_mixed_gmsh(const std::filesystem::path& path);
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> parse_mixed_gmsh(std::string_view bytes, const std::string& source);

/// throws as write_gmsh of simplices
void write_gmsh(const std::filesystem::path& path, const MixedMesh<2>& mesh, const GmshForm& form = {},
                const std::vector<PointField>& point_fields = {},
                const std::vector<CellField>& cell_fields = {});
[[nodiscard]] std::string format_gmsh(const MixedMesh<2>& mesh, const GmshForm& form = {},
                                      const std::vector<PointField>& point_fields = {},
                                      const std::vector<CellField>& cell_fields = {});
void write_gmsh(const std::filesystem::path& path, const MixedMesh<3>& mesh, const GmshForm& form = {},
                const std::vector<PointField>& point_fields = {},
                const std::vector<CellField>& cell_fields = {});
[[nodiscard]] std::string format_gmsh(const MixedMesh<3>& mesh, const GmshForm& form = {},
                                      const std::vector<PointField>& point_fields = {},
                                      const std::vector<CellField>& cell_fields = {});

}  // namespace leonhard::io
