// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/soup/read_soup.hpp"

#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/any_mesh_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/file_dimension.hpp"
#include "leonhard/mesh/io/formats/gmsh_soup.hpp"
#include "leonhard/mesh/io/formats/medit_soup.hpp"
#include "leonhard/mesh/io/formats/plot3d.hpp"
#include "leonhard/mesh/io/formats/stem_soups.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/su2_soup.hpp"
#include "leonhard/mesh/io/formats/vtk_grid.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {
namespace {

bool is_vtk(const std::string& extension) {
  return extension == ".vtu" || extension == ".pvtu" || extension == ".vtk";
}

VtkGrid read_vtk_grid(const std::filesystem::path& path, const std::string& extension) {
  const std::string bytes = read_whole_file(path), source = path.string();
  if (extension == ".pvtu") return read_pvtu_grid(bytes, source, path.parent_path());
  return extension == ".vtk" ? parse_legacy_vtk(bytes, source) : parse_vtu_grid(bytes, source);
}

AnySoup any_su2_soup(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string text = read_whole_file(path), source = path.string();
  if (su2_dimension(find_su2_zone(text, source, options.zone), source) == 2)
    return parse_su2_soup<2>(text, source, options.zone);
  return parse_su2_soup<3>(text, source, options.zone);
}

void refuse_zone(const std::filesystem::path& path, const std::string& extension,
                 const ReadOptions& options) {
  if (options.zone && extension != ".su2")
    throw InputError("--zone", path.string() + " has no zones", "leave the option out; .su2 files have them");
}

}  // namespace

const std::vector<std::string>& soup_extensions(int dimension) {
  static const std::vector<std::string> plane{".su2",  ".vtu",  ".msh", ".mesh", ".node",  ".ele",
                                              ".poly", ".edge", ".vtk", ".pvtu", ".p2dfmt"};
  static const std::vector<std::string> space{".su2", ".vtu",   ".msh",  ".mesh", ".node",
                                              ".ele", ".neigh", ".face", ".vtk",  ".pvtu"};
  return dimension == 2 ? plane : space;
}

template <int Dim>
MeshSoup<Dim> read_soup(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string extension =
                        known_extension(path, soup_extensions(Dim), Dim == 2 ? "mesh" : "mesh of space"),
                    source = path.string();
  refuse_zone(path, extension, options);
  if (extension == ".su2") return parse_su2_soup<Dim>(read_whole_file(path), source, options.zone);
  if (is_vtk(extension)) return vtk_soup<Dim>(read_vtk_grid(path, extension), source);
  if (extension == ".msh") return gmsh_soup<Dim>(parse_gmsh_data(read_whole_file(path), source), source);
  if (extension == ".mesh") return medit_soup<Dim>(parse_medit_data(read_whole_file(path), source), source);
  if constexpr (Dim == 2) {
    if (extension == ".p2dfmt") return read_plot3d_soup(path);
    return read_triangle_soup(path);
  } else {
    return read_tetgen_soup(path);
  }
}

AnySoup read_any_soup(const std::filesystem::path& path, const ReadOptions& options) {
  const std::string extension = known_extension(path, any_mesh_extensions(), "mesh"), source = path.string();
  refuse_zone(path, extension, options);
  if (extension == ".su2") return any_su2_soup(path, options);
  if (is_vtk(extension)) {
    VtkGrid grid = read_vtk_grid(path, extension);
    if (dimension_of(grid) == 2) return vtk_soup<2>(std::move(grid), source);
    return vtk_soup<3>(std::move(grid), source);
  }
  if (extension == ".msh") {
    GmshData data = parse_gmsh_data(read_whole_file(path), source);
    if (dimension_of(data) == 2) return gmsh_soup<2>(std::move(data), source);
    return gmsh_soup<3>(std::move(data), source);
  }
  if (extension == ".mesh") {
    MeditData data = parse_medit_data(read_whole_file(path), source);
    if (dimension_of(data) == 2) return medit_soup<2>(std::move(data), source);
    return medit_soup<3>(std::move(data), source);
  }
  if (extension == ".p2dfmt") return read_plot3d_soup(path);
  if (file_dimension(path) == 2) return read_triangle_soup(path);
  return read_tetgen_soup(path);
}

template MeshSoup<2> read_soup(const std::filesystem::path&, const ReadOptions&);
template MeshSoup<3> read_soup(const std::filesystem::path&, const ReadOptions&);

}  // namespace leonhard::io
