// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard {

/// What a reader of tetrahedral meshes returns: a mesh that passes `mesh::validate`, and in words what had to be decided
/// on the way (tetrahedra turned over, boundary faces without a marker, ...).
struct TetMeshFile {
  TetMesh mesh;
  std::vector<std::string> warnings;
};

namespace io {

/// Read a tetrahedral mesh, format by extension: .node, .ele, .face or .neigh (TetGen's files of one stem), .mesh
/// (Medit's), .vtu, .su2, .msh (Gmsh's).
///
/// throws InputError naming file, line, ids and coordinates: file missing, empty or cut short, unknown extension, a mesh
/// of the plane, other cells than tetrahedra, NaN, ids out of range, tetrahedra of no volume, inverted or given twice,
/// faces of three tetrahedra
[[nodiscard]] TetMeshFile read_tet_mesh(const std::filesystem::path& path);

/// Write a tetrahedral mesh, format by extension as in read_tet_mesh. The target appears whole or not at all. The mesh
/// must be valid (`mesh::validate`).
///
/// throws InputError for an unknown extension or a mesh that the format cannot carry (see the format's header),
/// OutputError if the file cannot be written
void write_tet_mesh(const std::filesystem::path& path, const TetMesh& mesh);

/// ".su2", ".vtu", ...: what read_tet_mesh and write_tet_mesh know.
[[nodiscard]] const std::vector<std::string>& tet_mesh_extensions();

}  // namespace io
}  // namespace leonhard
