// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/io/surface_contents.hpp"

namespace leonhard::io {

/// Read a surface, format by extension: .off, .obj, .stl and .ply (text or binary), .mesh (Medit's), .poly and .smesh
/// (TetGen's, with the .node beside it where it holds no points of its own), .msh (Gmsh's or JIGSAW's).
///
/// throws InputError naming file, and line or byte: file missing, empty or cut short, unknown extension, NaN, counts
/// that do not match, corners that are no vertices
[[nodiscard]] SurfaceFile read_surface(const std::filesystem::path& path);

/// Write a surface, format by extension: .off, .obj, .ply, .stl (text: nothing is rounded), and those of triangles and
/// quadrilaterals alone .mesh (Medit's), .msh (Gmsh's) and .vtu. Markers go into .mesh, .msh and .vtu; what is left
/// behind the result tells, "" if nothing.
///
/// throws  InputError for an unknown extension, polygons that the format has not; OutputError if the file cannot be written
std::string write_surface(const std::filesystem::path& path, const SurfaceFile& surface);

/// What write_surface knows.
[[nodiscard]] const std::vector<std::string>& surface_output_extensions();

/// ".off", ".obj", ...: what read_surface knows.
[[nodiscard]] const std::vector<std::string>& surface_extensions();

}  // namespace leonhard::io
