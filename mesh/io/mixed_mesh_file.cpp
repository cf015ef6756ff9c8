// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/mixed_mesh_file.hpp"

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/gmsh.hpp"
#include "leonhard/mesh/io/formats/plot3d.hpp"
#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::io {

const std::vector<std::string>& mixed_mesh_extensions() {
  static const std::vector<std::string> known{".su2", ".vtu", ".msh"};
  return known;
}

template <int Dim>
MixedMeshFile<Dim> read_mixed_mesh(const std::filesystem::path& path) {
  std::vector<std::string> known = mixed_mesh_extensions();
  if (Dim == 2) known.push_back(".p2dfmt");
  const std::string extension = known_extension(path, known, "mesh of mixed cells");
  if constexpr (Dim == 2)
    if (extension == ".p2dfmt") return read_plot3d(path);
  if (extension == ".vtu") return read_mixed_vtu<Dim>(path);
  if (extension == ".msh") return read_mixed_gmsh<Dim>(path);
  return read_mixed_su2<Dim>(path);
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
  write_su2(path, mesh);
}

template MixedMeshFile<2> read_mixed_mesh<2>(const std::filesystem::path&);
template MixedMeshFile<3> read_mixed_mesh<3>(const std::filesystem::path&);
template void write_mixed_mesh(const std::filesystem::path&, const MixedMesh<2>&,
                               const std::vector<PointField>&, const std::vector<CellField>&);
template void write_mixed_mesh(const std::filesystem::path&, const MixedMesh<3>&,
                               const std::vector<PointField>&, const std::vector<CellField>&);

}  // namespace leonhard::io
