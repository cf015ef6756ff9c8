// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace leonhard::io {

/// Whether a mesh file is of the plane (2: read_mesh) or of space (3: read_tet_mesh), by its extension and as little of
/// its contents as tells it: the head of .node, .ele, .poly, .su2 and JIGSAW's .msh; all of a .vtu, of Gmsh's .msh
/// and of a .mesh that calls itself one of space, which have to be searched for cells of space. .face and .smesh are of space, .edge and .p2dfmt of the plane; of .neigh the head.
///
/// A .vtu, .msh or .mesh without such cells is of space if its points do not lie in a plane z = const. The answer is no promise
/// that the file can be read.
///
/// throws InputError naming file and line: file missing or empty, unknown extension, a head that does not tell
[[nodiscard]] int file_dimension(const std::filesystem::path& path);

}  // namespace leonhard::io
