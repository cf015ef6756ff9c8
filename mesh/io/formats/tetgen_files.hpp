// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "leonhard/mesh/io/file_contents.hpp"

namespace leonhard::io {

/// The files of a mesh in the formats of H. Si's TetGen (https://wias-berlin.de/software/tetgen/fformats.html), as texts.
/// Numbering from 0 or 1 is detected; # starts a comment.
struct TetgenFileTexts {
  std::string node;                  ///< vertices: coordinates, marker (attributes are skipped)
  std::string ele;                   ///< tetrahedra: corners, and the first attribute as region
  std::optional<std::string> face;   ///< faces with markers: the boundary and interfaces
  std::optional<std::string> neigh;  ///< neighbours; written, not read (they follow from the tetrahedra)
};

/// Read STEM.node and STEM.ele (path is one of the four), and STEM.face for the markers where it exists.
///
/// A boundary face that it does not list gets a marker (see mesh_soup.hpp); listed inner faces with a marker other than 0
/// are interfaces.
///
/// throws InputError: numbers out of order, tetrahedra with ten nodes, a mesh of the plane, and as read_tet_mesh
[[nodiscard]] TetMeshFile read_tetgen_files(const std::filesystem::path& path);

/// The same from texts; source is the stem ("wing" for wing.node, wing.ele, ...).
[[nodiscard]] TetMeshFile parse_tetgen_files(const TetgenFileTexts& texts, const std::string& source);

/// Write STEM.node, STEM.ele, STEM.face and STEM.neigh, numbered from 0, so that read_tetgen_files gives the mesh back,
/// marker names included (as leading comments "# marker 2 farfield" of the .face file); interfaces with the marker 0
/// alone are lost.
///
/// throws InputError if a marker name holds a line break or begins or ends with a blank, OutputError
void write_tetgen_files(const std::filesystem::path& path, const TetMesh& mesh);

/// The texts that write_tetgen_files writes.
[[nodiscard]] TetgenFileTexts format_tetgen_files(const TetMesh& mesh);

}  // namespace leonhard::io
