// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <variant>

#include "leonhard/mesh/io/any_mesh_file.hpp"
#include "leonhard/mesh/io/surface_contents.hpp"

namespace leonhard {

/// A .msh or .mesh of the plane that has edges and no cells: read_pslg reads it.
struct EdgesAlone {};

/// What a file of a mesh format holds: a mesh, or faces in space without cells, or edges in the plane without cells.
using AnyContents = std::variant<AnyMeshFile, SurfaceFile, EdgesAlone>;

namespace io {

/// Read whatever a file of one of any_mesh_extensions() holds. Formats of surfaces alone (.off .obj .stl .ply) are
/// read_surface's.
///
/// options  weld joins vertices of meshes alone
/// throws   InputError as read_any_mesh does; a surface's corners that are no vertices
[[nodiscard]] AnyContents read_any_contents(const std::filesystem::path& path,
                                            const ReadOptions& options = {});

}  // namespace io
}  // namespace leonhard
