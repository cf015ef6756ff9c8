// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::io {

/// Read a triangle mesh, format by extension: .su2, .vtu, .node or .ele (Triangle's pair, with .poly or .edge
/// beside it for the markers), .msh (Gmsh's).
///
/// throws InputError naming file, line, ids and coordinates: file missing, empty or cut short, unknown
/// extension, NaN, ids out of range, zero-area, inverted or overlapping cells, boundary edges without a
/// marker
[[nodiscard]] MeshFile read_mesh(const std::filesystem::path& path);

/// Write a triangle mesh, format by extension as in read_mesh. The target appears whole or not at all. The
/// mesh must be valid (`mesh::validate`).
///
/// fields  values at vertices and in triangles, for .vtu and .msh only; read_mesh gives them back to the last bit
/// throws InputError for an unknown extension, a mesh or fields that the format cannot carry (see the format's
/// header), fields that do not fit the mesh; OutputError if the file cannot be written
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const std::vector<PointField>& point_fields = {},
                const std::vector<CellField>& cell_fields = {});

/// ".su2", ".vtu", ".node", ".ele", ".poly", ".msh": what read_mesh and write_mesh know.
[[nodiscard]] const std::vector<std::string>& mesh_extensions();

}  // namespace leonhard::io
