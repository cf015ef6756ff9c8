// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "leonhard/mesh/io/read_options.hpp"

namespace leonhard {

/// A mesh of whatever its file holds: of simplices alone where all cells are, else of mixed cells.
struct AnyMeshFile {
  std::variant<TriangleMesh, TetMesh, MixedMesh<2>, MixedMesh<3>> mesh;
  std::vector<std::string> warnings;
  std::vector<PointField> point_fields;  ///< in the file's order
  std::vector<CellField> cell_fields;

  [[nodiscard]] int dimension() const { return mesh.index() % 2 == 0 ? 2 : 3; }
};

namespace io {

/// Read a mesh of the plane or of space and of any cells, format by extension (see any_mesh_extensions). Its contents say
/// which dimension it has: 3 if there are cells of space or points that do not lie in a plane z = const.
///
/// throws  InputError as read_mesh, read_tet_mesh and read_mixed_mesh do
[[nodiscard]] AnyMeshFile read_any_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// How a mesh is written.
struct WriteOptions {
  bool msh_2_2 = false;     ///< .msh files in version 2.2, else 4.1
  bool msh_binary = false;  ///< and in binary
};

/// Write a mesh with its fields, format by extension. What the format has no place for is left out: left_behind tells it.
///
/// throws  InputError as write_mesh, write_tet_mesh and write_mixed_mesh do; OutputError
void write_any_mesh(const std::filesystem::path& path, const AnyMeshFile& file,
                    const WriteOptions& options = {});

/// What a format, by the extension of a file, cannot hold of a mesh: regions, inner facets, names, vertex markers, fields. In
/// words, e.g. "regions (2 different numbers), 118 inner faces, the field \"temperature\""; empty if nothing is lost.
[[nodiscard]] std::string left_behind(const std::filesystem::path& path, const AnyMeshFile& file);

/// Negative markers and regions, and regions that are no whole numbers, get the smallest positive numbers that are free and a
/// name with the old one ("marker_-2"), unless they have a name.
/// returns  in words which numbers changed, empty if none
[[nodiscard]] std::string renumber_markers(AnyMeshFile& file);

/// A point field by its name, all values finite, of 1 to 3 components. The markers of the vertices are the field "marker".
/// source   names the file in errors
/// throws  InputError if there is none (the message lists those there are), or it is not finite
[[nodiscard]] PointField finite_field(const AnyMeshFile& file, const std::string& name,
                                      const std::string& source);

/// What read_any_mesh knows.
[[nodiscard]] const std::vector<std::string>& any_mesh_extensions();

/// What write_any_mesh knows for meshes of this kind.
[[nodiscard]] std::vector<std::string> any_mesh_output_extensions(const AnyMeshFile& file);

}  // namespace io
}  // namespace leonhard
