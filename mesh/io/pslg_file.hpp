// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/pslg.hpp"

namespace leonhard::io {

/// Read a planar straight-line graph, format by extension: .poly (Triangle's; points may be in the .node file
/// of the same name when the .poly declares 0 of them), .msh (Gmsh's) and .mesh (Medit's), whose edges with their markers
/// and names are segments: of a mesh its boundary and the marked edges within, of a file of edges alone all of them, each once.
/// Of these two points on no segment are left out, and holes are not told (app/geometry finds them).
///
/// throws InputError naming file and line: file missing, empty or cut short, unknown extension, NaN, letters
/// among numbers, point numbers out of range; a .msh or .mesh of space, without edges, or as read_mixed_mesh
[[nodiscard]] Pslg read_pslg(const std::filesystem::path& path);

/// The same, and in words what was left out or mended.
[[nodiscard]] Pslg read_pslg(const std::filesystem::path& path, std::vector<std::string>& warnings);

/// The edges of a .msh or .mesh as read_pslg gives them.
struct EdgeGraphFile {
  Pslg pslg;
  std::size_t outline_segments =
      0;  ///< the first ones bound the domain: those of a mesh's boundary, of edges alone all
  std::vector<std::string> warnings;
};

/// throws  InputError as read_pslg does
[[nodiscard]] EdgeGraphFile read_edge_graph(const std::filesystem::path& path);

/// ".poly", ".msh", ".mesh": what read_pslg knows.
[[nodiscard]] const std::vector<std::string>& pslg_extensions();

/// Write a planar straight-line graph as .poly, to the last bit.
/// throws InputError for an unknown extension, OutputError if the file cannot be written
void write_pslg(const std::filesystem::path& path, const Pslg& pslg);

}  // namespace leonhard::io
