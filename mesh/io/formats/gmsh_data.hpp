// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/cell_kind.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"

/// What a file of Gmsh states, before anything is checked. Not meant for callers of the room.
namespace leonhard::io {

/// A line or a cell of some kind, its corners in the order of CellKind. Nodes exist: the file's tags have become ids in the
/// file's order.
struct GmshCell {
  std::array<VertexId, most_cell_corners> corners;
  Marker group = 0;        ///< number of its physical group, 0 if it is in none
  std::uint32_t line = 0;  ///< of the file; 0 in a binary one
  std::uint64_t tag = 0;   ///< its number in the file, by which data name it; to write, 0: the next one
};

/// A section $NodeData or $ElementData.
struct GmshValues {
  bool of_nodes{};
  std::string name;
  std::size_t components = 1;
  std::vector<std::uint64_t>
      rows;                    ///< what has values: indices of points, or tags of elements; repeated maybe
  std::vector<double> values;  ///< components a row
};

struct GmshData {
  std::vector<Point3> points;
  std::vector<GmshCell> lines, triangles, quadrilaterals, tetrahedra, hexahedra, prisms, pyramids;
  std::map<std::pair<int, Marker>, std::string> names;  ///< of physical groups, by dimension and number
  std::vector<GmshValues> values;                       ///< in the file's order
  std::vector<std::string> warnings;
};

/// A file of format 1, 2.0 to 2.2, 4.0 or 4.1, text or binary of either byte order (https://gmsh.info/doc/texinfo/gmsh.html,
/// "Gmsh file formats"). Points are left out, and sections of other data than nodes' and elements' with a warning. Elements of
/// higher order are taken by their corners, with a warning.
///
/// Groups: an element in several groups (formats 1 and 2: listed several times) has the first one, which a warning tells. An
/// element in none has the number of the geometry's entity that it lies on, or the next free one where that number is a
/// group's; a warning tells it. Elements of groups named marker_0 or region_0, which format_gmsh_data writes, have 0. The sign
/// of a physical group, which tells a direction, is dropped.
///
/// Elements on the seams between parts of a partitioned mesh, which are no part of its geometry, are left out.
///
/// throws InputError with line or byte: no .msh file, another version; elements that are no lines, triangles, quadrilaterals,
/// tetrahedra, hexahedra, prisms or pyramids; nodes that are missing, repeated or not finite; a file cut short
[[nodiscard]] GmshData parse_gmsh_data(std::string_view bytes, const std::string& source);

/// The name of the group of cells that have no marker or region in the mesh: Gmsh drops elements without a group.
[[nodiscard]] inline std::string gmsh_name_of_none(bool of_cells) {
  return of_cells ? "region_0" : "marker_0";
}

}  // namespace leonhard::io
