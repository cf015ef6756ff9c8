// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/mixed_mesh_file.hpp"

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/gmsh.hpp"
#include "leonhard/mesh/io/formats/medit.hpp"
#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/soup/read_soup.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::io {

const std::vector<std::string>& mixed_mesh_extensions() {
  static const std::vector<std::string> known{".su2", ".vtu", ".msh", ".mesh"};
  return known;
}

template <int Dim>
MixedMeshFile<Dim> read_mixed_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  return assemble_mixed(read_soup<Dim>(path, options), options);
}

template <int Dim>
void write_mixed_mesh(const std::filesystem::path& path, const MixedMesh<Dim>& mesh,
                      const std::vector<PointField>& point_fields,
                      const std::vector<CellField>& cell_fields) {
  const std::string extension = known_extension(path, mixed_mesh_extensions(), "mesh of mixed cells");
  mesh::require_ids_in_range(mesh);
  if (extension == ".vtu") return write_vtu(path, mesh, point_fields, cell_fields);
  if (extension == ".msh") return write_gmsh(path, mesh, {}, point_fields, cell_fields);
  if (!point_fields.empty() || !cell_fields.empty())
    throw InputError(path.string(), extension + " files carry no fields", "write a .vtu or a .msh file");
  if (extension == ".mesh") return write_file_atomically(path, format_medit(mesh));
  write_su2(path, mesh);
}

template MixedMeshFile<2> read_mixed_mesh<2>(const std::filesystem::path&, const ReadOptions&);
template MixedMeshFile<3> read_mixed_mesh<3>(const std::filesystem::path&, const ReadOptions&);
template void write_mixed_mesh(const std::filesystem::path&, const MixedMesh<2>&,
                               const std::vector<PointField>&, const std::vector<CellField>&);
template void write_mixed_mesh(const std::filesystem::path&, const MixedMesh<3>&,
                               const std::vector<PointField>&, const std::vector<CellField>&);

}  // namespace leonhard::io
