// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/io/read_options.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::io {

/// Read a triangle mesh, format by extension: .su2, .vtu, .pvtu, .vtk, .msh (Gmsh's), .mesh (Medit's), .node or .ele
/// (Triangle's pair, with .poly or .edge beside it for the markers), .p2dfmt (PLOT3D's). Quadrilaterals are split.
///
/// What is mended on the way the warnings tell: cells turned over, vertices that no cell uses, boundary edges without a marker.
///
/// throws InputError naming file, line, ids and coordinates: file missing, empty or cut short, unknown
/// extension, NaN, ids out of range, zero-area or overlapping cells, marked edges that are none of the mesh
[[nodiscard]] MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// Write a triangle mesh, format by extension (see mesh_extensions). The target appears whole or not at all. The
/// mesh must be valid (`mesh::validate`).
///
/// fields  values at vertices and in triangles, for .vtu and .msh only; read_mesh gives them back to the last bit
/// throws InputError for an unknown extension, a mesh or fields that the format cannot carry (see the format's
/// header), fields that do not fit the mesh; OutputError if the file cannot be written
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const std::vector<PointField>& point_fields = {},
                const std::vector<CellField>& cell_fields = {});

/// ".su2", ".vtu", ".node", ".ele", ".poly", ".msh", ".mesh": what both read_mesh and write_mesh know.
[[nodiscard]] const std::vector<std::string>& mesh_extensions();

}  // namespace leonhard::io
