// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/cell_kind.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"

/// What a Medit file states, before anything is checked. Not meant for callers of the room.
namespace leonhard::io {

/// An edge or a cell by its corners in the order of CellKind; vertices are numbered from 0 here, from 1 in the file.
struct MeditCell {
  std::array<VertexId, most_cell_corners> corners{};
  Marker reference{};
  std::uint32_t line = 0;
};

struct MeditData {
  int dimension = 3;
  std::vector<Point3> points;      ///< of the plane with z = 0
  std::vector<Marker> references;  ///< one a point
  std::vector<MeditCell> edges, triangles, quadrilaterals, tetrahedra, hexahedra, prisms, pyramids;
  std::map<Marker, std::string> marker_names;  ///< from leading comments "# marker 2 farfield"
  std::map<Marker, std::string> region_names;  ///< from leading comments "# region 2 steel"
  std::vector<std::string> warnings;           ///< sections that were passed over
};

/// Sections in any order; entries may span lines; # starts a comment. Cells of higher order (TrianglesP2, TetrahedraP2 and the
/// like) are taken by their corners, which a warning tells. Edges of a mesh of space are passed over.
/// throws InputError with the line: a keyword that is none, numbers below 1, a file cut short
[[nodiscard]] MeditData parse_medit_data(std::string_view text, const std::string& source);

/// 2 if the file says so, or has edges and cells of the plane alone, in a plane z = const (Gmsh's files say 3 always); else 3.
[[nodiscard]] int dimension_of(const MeditData& data);

}  // namespace leonhard::io
