// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/read_options.hpp"
#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard {

/// What a reader of mixed cells returns: a mesh that passes `mesh::validate`, and in the plane `mesh::validate_embedding`,
/// and in words what had to be decided on the way (cells turned over, boundary facets without a marker, ...).
template <int Dim>
struct MixedMeshFile {
  MixedMesh<Dim> mesh;
  std::vector<std::string> warnings;
  std::vector<PointField> point_fields;  ///< in the file's order
  std::vector<CellField> cell_fields;
};

namespace io {

/// Read a mesh of mixed cells, format by extension: .su2, .vtu, .pvtu, .vtk, .msh (Gmsh's), .mesh (Medit's), those of
/// read_mesh or read_tet_mesh that hold simplices alone, in the plane .p2dfmt (PLOT3D's formatted grids, with a map .nmf beside
/// it or without). What is mended on the way the warnings tell, as in read_mesh.
///
/// throws  InputError naming file, line, ids and coordinates: file missing, empty or cut short, unknown extension, a mesh
///         of the other dimension, NaN, ids out of range, cells that are flat or tangled, that overlap (in the plane) or do
///         not conform
template <int Dim>
[[nodiscard]] MixedMeshFile<Dim> read_mixed_mesh(const std::filesystem::path& path,
                                                 const ReadOptions& options = {});

/// Write a mesh of mixed cells, format by extension: .su2, .vtu, .msh, .mesh. The target appears whole or not at all. The mesh
/// must be valid (`mesh::validate`).
///
/// fields  values at vertices and in cells, for .vtu and .msh only; read_mixed_mesh gives them back to the last bit
/// throws  InputError for an unknown extension, a mesh or fields that the format cannot carry (see the format's header),
///         fields that do not fit the mesh; OutputError if the file cannot be written
template <int Dim>
void write_mixed_mesh(const std::filesystem::path& path, const MixedMesh<Dim>& mesh,
                      const std::vector<PointField>& point_fields = {},
                      const std::vector<CellField>& cell_fields = {});

/// ".su2", ".vtu", ".msh", ".mesh": what read_mixed_mesh and write_mixed_mesh both know.
[[nodiscard]] const std::vector<std::string>& mixed_mesh_extensions();

}  // namespace io
}  // namespace leonhard
