// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/mixed_mesh_file.hpp"

#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/su2.hpp"

namespace leonhard::io {

const std::vector<std::string>& mixed_mesh_extensions() {
  static const std::vector<std::string> known{".su2"};
  return known;
}

template <int Dim>
MixedMeshFile<Dim> read_mixed_mesh(const std::filesystem::path& path) {
  (void)known_extension(path, mixed_mesh_extensions(), "mesh of mixed cells");
  return read_mixed_su2<Dim>(path);
}

template <int Dim>
void write_mixed_mesh(const std::filesystem::path& path, const MixedMesh<Dim>& mesh) {
  (void)known_extension(path, mixed_mesh_extensions(), "mesh of mixed cells");
  mesh::require_ids_in_range(mesh);
  write_su2(path, mesh);
}

template MixedMeshFile<2> read_mixed_mesh<2>(const std::filesystem::path&);
template MixedMeshFile<3> read_mixed_mesh<3>(const std::filesystem::path&);
template void write_mixed_mesh(const std::filesystem::path&, const MixedMesh<2>&);
template void write_mixed_mesh(const std::filesystem::path&, const MixedMesh<3>&);

}  // namespace leonhard::io
