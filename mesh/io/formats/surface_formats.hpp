// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "leonhard/mesh/io/surface_contents.hpp"

/// One function a surface format, each in a file of its own; what read_surface chooses from. source names the text in
/// errors; all throw InputError as read_surface does.
namespace leonhard::io {

/// Geomview's Object File Format (https://people.sc.fsu.edu/~jburkardt/data/off/off.html): OFF, or COFF, NOFF, ... with
/// colours and normals, which are left out. # starts a comment. The count of edges may be missing.
[[nodiscard]] SurfaceFile parse_off(std::string_view text, const std::string& source);

/// Wavefront's .obj: lines v and f, with negative numbers and corners such as 3/1/2; all other lines are passed over.
[[nodiscard]] SurfaceFile parse_obj(std::string_view text, const std::string& source);

/// Stereolithography, text or binary (which of the two follows from the size, since binary files may begin with
/// "solid"). Corners of equal coordinates are one vertex: the format has no other way to say so.
[[nodiscard]] SurfaceFile parse_stl(std::string_view bytes, const std::string& source);

/// The Stanford format (G. Turk, 1994): ascii, binary_little_endian and binary_big_endian; properties x, y and z of
/// element vertex, the list vertex_indices or vertex_index of element face. All else is passed over.
[[nodiscard]] SurfaceFile parse_ply(std::string_view bytes, const std::string& source);

/// TetGen's .poly (https://wias-berlin.de/software/tetgen/fformats.poly.html): facets of several polygons with markers.
/// node is the sibling .node file's text, needed where the .poly declares 0 points. Holes and regions are not read.
[[nodiscard]] SurfaceFile parse_surface_poly(std::string_view poly, const std::optional<std::string>& node,
                                             const std::string& source);

/// TetGen's .smesh: as .poly, one polygon a facet.
[[nodiscard]] SurfaceFile parse_smesh(std::string_view smesh, const std::optional<std::string>& node,
                                      const std::string& source);

/// JIGSAW's .msh (https://github.com/dengwirda/jigsaw/wiki/MSH-File-Format): ndims=3, POINT= and TRIA3= with their
/// tags as markers; other sections are passed over with a warning.
[[nodiscard]] SurfaceFile parse_jigsaw(std::string_view text, const std::string& source);

/// Medit's .mesh: the triangles and quadrilaterals of a file in space.
[[nodiscard]] SurfaceFile parse_medit_surface(std::string_view text, const std::string& source);

/// Gmsh's .msh: triangles and quadrilaterals with their physical groups as markers.
[[nodiscard]] SurfaceFile parse_gmsh_surface(std::string_view bytes, const std::string& source);

}  // namespace leonhard::io
