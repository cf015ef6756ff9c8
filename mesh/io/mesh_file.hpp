// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// What a mesh reader returns: a mesh that passes `mesh::validate` and `mesh::validate_embedding`, and in words what had
/// to be decided on the way (quadrilaterals split, clockwise or inverted cells turned over, boundary facets without a
/// marker, ...).
template <int Dim>
struct SimplexMeshFile {
  SimplexMesh<Dim> mesh;
  std::vector<std::string> warnings;
};

using MeshFile = SimplexMeshFile<2>;

namespace io {

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
/// throws InputError for an unknown extension or a mesh that the format cannot carry (see the format's
/// header), OutputError if the file cannot be written
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh);

/// ".su2", ".vtu", ".node", ".ele", ".poly", ".msh": what read_mesh and write_mesh know.
[[nodiscard]] const std::vector<std::string>& mesh_extensions();

}  // namespace io
}  // namespace leonhard
