// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/mesh_file.hpp"

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/ids_in_range.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/gmsh.hpp"
#include "leonhard/mesh/io/formats/medit.hpp"
#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/formats/triangle_files.hpp"
#include "leonhard/mesh/io/soup/read_soup.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::io {

const std::vector<std::string>& mesh_extensions() {
  static const std::vector<std::string> known{".su2", ".vtu", ".node", ".ele", ".poly", ".msh", ".mesh"};
  return known;
}

MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  return assemble_simplices(read_soup<2>(path, options), options);
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const std::vector<PointField>& point_fields, const std::vector<CellField>& cell_fields) {
  const std::string extension = known_extension(path, mesh_extensions(), "mesh");
  mesh::require_ids_in_range(mesh);
  if (extension == ".vtu") return write_vtu(path, mesh, point_fields, cell_fields);
  if (extension == ".msh") return write_gmsh(path, mesh, {}, point_fields, cell_fields);
  if (!point_fields.empty() || !cell_fields.empty())
    throw InputError(path.string(), extension + " files carry no fields", "write a .vtu or a .msh file");
  if (extension == ".su2") return write_su2(path, mesh);
  if (extension == ".mesh") return write_file_atomically(path, format_medit(mesh));
  return write_triangle_files(path, mesh);
}

}  // namespace leonhard::io
