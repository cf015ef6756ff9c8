// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/mesh/io/file_contents.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard::io {

/// The files of a mesh in the formats of J. R. Shewchuk's Triangle
/// (https://www.cs.cmu.edu/~quake/triangle.html), as texts. Numbering from 0 or 1 is detected; # starts a
/// comment.
struct TriangleFileTexts {
  std::string node;                  ///< vertices: coordinates, marker (attributes are skipped)
  std::string ele;                   ///< triangles: corners, and the first attribute as region
  std::optional<std::string> poly;   ///< segments of the mesh with markers: its boundary and constraints
  std::optional<std::string> edge;   ///< edges with markers, used for the boundary where there is no .poly
  std::optional<std::string> neigh;  ///< neighbours; written, not read (they follow from the triangles)
};

/// Read STEM.node and STEM.ele (path is either, or STEM.poly), and STEM.poly or STEM.edge for the markers
/// where they exist.
///
/// A boundary edge that neither names gets the marker its two ends share if it is not 0, else 1, as Triangle
/// does; a warning tells how many. A STEM.poly that holds points of its own is the geometry and not part of
/// the mesh: it is left alone.
///
/// throws InputError: file missing or cut short, NaN, numbers out of order or out of range, triangles with
/// six nodes, segments that are no edges of the mesh, bad cells as in read_su2
[[nodiscard]] MeshFile read_triangle_files(const std::filesystem::path& path);

/// The same from texts; source is the stem ("wing" for wing.node, wing.ele, ...).
[[nodiscard]] MeshFile parse_triangle_files(const TriangleFileTexts& texts, const std::string& source);

/// Write STEM.node, STEM.ele, STEM.poly and STEM.neigh, numbered from 0, so that read_triangle_files gives
/// the mesh back, marker names included (as leading comments "# marker 2 farfield" of the .poly file).
///
/// throws InputError if a marker name holds a line break or begins or ends with a blank, OutputError
void write_triangle_files(const std::filesystem::path& path, const TriangleMesh& mesh);

/// The texts that write_triangle_files writes (no .edge).
[[nodiscard]] TriangleFileTexts format_triangle_files(const TriangleMesh& mesh);

/// A .poly file as a planar straight-line graph. node is the sibling .node file's text, needed when the .poly
/// declares 0 points. Attributes of points are skipped; a region line with four numbers gives one value to
/// attribute and largest area, as Triangle does; an area that is not positive means no bound. throws
/// InputError: as read_triangle_files; a segment whose ends are the same point
/// warnings  if it is not null, in words what was left out: segments from a vertex to itself
[[nodiscard]] Pslg parse_poly(std::string_view poly, const std::optional<std::string>& node,
                              const std::string& source, std::vector<std::string>* warnings = nullptr);

/// The .poly text, numbered from 0, that parse_poly turns back into the same graph.
/// throws InputError if a marker name holds a line break or begins or ends with a blank
[[nodiscard]] std::string format_poly(const Pslg& pslg);

}  // namespace leonhard::io
