// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "leonhard/mesh/io/surface_contents.hpp"

/// One function a surface format; what write_surface chooses from. Coordinates to the last bit.
namespace leonhard::io {

[[nodiscard]] std::string format_off(const SurfaceFile& surface);
[[nodiscard]] std::string format_obj(const SurfaceFile& surface);
[[nodiscard]] std::string format_ply(const SurfaceFile& surface);  ///< text

/// Text, polygons as the triangles from their first corner, the vertices repeated.
[[nodiscard]] std::string format_stl(const SurfaceFile& surface);

/// Triangles and quadrilaterals with their markers: Medit's .mesh and Gmsh's .msh 4.1 in text.
/// throws  InputError for polygons of more corners; of the .msh for negative markers
[[nodiscard]] std::string format_medit_surface(const SurfaceFile& surface);
[[nodiscard]] std::string format_gmsh_surface(const SurfaceFile& surface);

}  // namespace leonhard::io
