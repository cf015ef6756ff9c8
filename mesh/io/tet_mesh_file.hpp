// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/read_options.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::io {

/// Read a tetrahedral mesh, format by extension: .node, .ele, .face or .neigh (TetGen's files of one stem), .mesh
/// (Medit's), .vtu, .pvtu, .vtk, .su2, .msh (Gmsh's). Other cells of space are split if options say so. What is mended on
/// the way the warnings tell, as in read_mesh.
///
/// throws InputError naming file, line, ids and coordinates: file missing, empty or cut short, unknown extension, a mesh
/// of the plane, other cells than tetrahedra, NaN, ids out of range, tetrahedra of no volume, overlapping or
/// given twice, faces of three tetrahedra
[[nodiscard]] TetMeshFile read_tet_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// Write a tetrahedral mesh, format by extension (see tet_mesh_extensions). The target appears whole or not at all. The mesh
/// must be valid (`mesh::validate`).
///
/// fields  values at vertices and in tetrahedra, for .vtu and .msh only; read_tet_mesh gives them back to the last bit
/// throws InputError for an unknown extension, a mesh or fields that the format cannot carry (see the format's header),
/// fields that do not fit the mesh; OutputError if the file cannot be written
void write_tet_mesh(const std::filesystem::path& path, const TetMesh& mesh,
                    const std::vector<PointField>& point_fields = {},
                    const std::vector<CellField>& cell_fields = {});

/// ".su2", ".vtu", ...: what both read_tet_mesh and write_tet_mesh know.
[[nodiscard]] const std::vector<std::string>& tet_mesh_extensions();

}  // namespace leonhard::io
