// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/surface_file.hpp"

#include <algorithm>
#include <optional>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/formats/surface_write.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"
#include "leonhard/mesh/io/vtu.hpp"

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

void write_as_vtu(const std::filesystem::path& path, const SurfaceFile& surface) {
  std::vector<MixedFacet<3>> facets;
  for (std::size_t i = 0; i < surface.polygon_count(); ++i) {
    const auto polygon = surface.polygon(i);
    if (polygon.size() != 3 && polygon.size() != 4)
      throw InputError("polygon " + std::to_string(i),
                       "it has " + std::to_string(polygon.size()) + " corners",
                       "a .vtu of ours has triangles and quadrilaterals; write .off, .obj, .ply or .stl");
    facets.emplace_back(polygon);
  }
  write_surface_vtu(path, PerId<VertexId, Point3>(surface.set.points), facets, {}, {}, surface.markers);
}

}  // namespace

std::string write_surface(const std::filesystem::path& path, const SurfaceFile& surface) {
  const std::string extension = known_extension(path, surface_output_extensions(), "surface");
  const bool has_marker = std::ranges::any_of(surface.markers, [](Marker marker) { return marker != 0; });
  const bool loses_markers = has_marker && extension != ".mesh" && extension != ".msh" && extension != ".vtu";
  if (extension == ".vtu") {
    write_as_vtu(path, surface);
  } else {
    write_file_atomically(path, extension == ".off"    ? format_off(surface)
                                : extension == ".obj"  ? format_obj(surface)
                                : extension == ".ply"  ? format_ply(surface)
                                : extension == ".stl"  ? format_stl(surface)
                                : extension == ".mesh" ? format_medit_surface(surface)
                                                       : format_gmsh_surface(surface));
  }
  return loses_markers ? "markers of the polygons" : "";
}

const std::vector<std::string>& surface_output_extensions() {
  static const std::vector<std::string> known{".off", ".obj", ".stl", ".ply", ".mesh", ".msh", ".vtu"};
  return known;
}

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
