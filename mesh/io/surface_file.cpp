// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/surface_file.hpp"

#include <optional>

#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

std::optional<std::string> node_beside(std::filesystem::path path) {
  path.replace_extension(".node");
  if (!std::filesystem::exists(path)) return std::nullopt;
  return read_whole_file(path);
}

/// Two programs have chosen .msh; Gmsh's files begin with $MeshFormat.
SurfaceFile parse_msh(std::string_view bytes, const std::string& source) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool is_gmsh = first != std::string_view::npos && bytes[first] == '$';
  return is_gmsh ? parse_gmsh_surface(bytes, source) : parse_jigsaw(bytes, source);
}

}  // namespace

const std::vector<std::string>& surface_extensions() {
  static const std::vector<std::string> known{".off",  ".obj",  ".stl",   ".ply",
                                              ".mesh", ".poly", ".smesh", ".msh"};
  return known;
}

SurfaceFile read_surface(const std::filesystem::path& path) {
  const std::string extension = known_extension(path, surface_extensions(), "surface"),
                    source = path.string();
  const std::string bytes = read_whole_file(path);
  if (extension == ".off") return parse_off(bytes, source);
  if (extension == ".obj") return parse_obj(bytes, source);
  if (extension == ".stl") return parse_stl(bytes, source);
  if (extension == ".ply") return parse_ply(bytes, source);
  if (extension == ".mesh") return parse_medit_surface(bytes, source);
  if (extension == ".poly") return parse_surface_poly(bytes, node_beside(path), source);
  if (extension == ".smesh") return parse_smesh(bytes, node_beside(path), source);
  return parse_msh(bytes, source);
}

}  // namespace leonhard::io
