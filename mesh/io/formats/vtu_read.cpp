// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/any_mesh_file.hpp"
#include "leonhard/mesh/io/formats/vtk_grid.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::io {

MeshFile parse_vtu(std::string_view bytes, const std::string& source) {
  return assemble_simplices(vtk_soup<2>(parse_vtu_grid(bytes, source), source));
}
TetMeshFile parse_tet_vtu(std::string_view bytes, const std::string& source) {
  return assemble_simplices(vtk_soup<3>(parse_vtu_grid(bytes, source), source));
}
template <int Dim>
MixedMeshFile<Dim> parse_mixed_vtu(std::string_view bytes, const std::string& source) {
  return assemble_mixed(vtk_soup<Dim>(parse_vtu_grid(bytes, source), source));
}

MeshFile read_vtu(const std::filesystem::path& path) {
  return parse_vtu(read_whole_file(path), path.string());
}
TetMeshFile read_tet_vtu(const std::filesystem::path& path) {
  return parse_tet_vtu(read_whole_file(path), path.string());
}
template <int Dim>
MixedMeshFile<Dim> read_mixed_vtu(const std::filesystem::path& path) {
  return parse_mixed_vtu<Dim>(read_whole_file(path), path.string());
}

PointField read_vtu_field(const std::filesystem::path& path, const std::string& name) {
  return finite_field(read_any_mesh(path), name, path.string());
}

template MixedMeshFile<2> parse_mixed_vtu<2>(std::string_view, const std::string&);
template MixedMeshFile<3> parse_mixed_vtu<3>(std::string_view, const std::string&);
template MixedMeshFile<2> read_mixed_vtu<2>(const std::filesystem::path&);
template MixedMeshFile<3> read_mixed_vtu<3>(const std::filesystem::path&);

}  // namespace leonhard::io
