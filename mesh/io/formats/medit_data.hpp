// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"

/// What a Medit file in space states, before anything is checked. Not meant for callers of the room.
namespace leonhard::io {

/// A triangle, quadrilateral or tetrahedron; vertices are numbered from 0 here, from 1 in the file.
struct MeditCell {
  std::array<VertexId, 4> corners;
  Marker reference{};
  std::uint32_t line = 0;
};

struct MeditData {
  std::vector<Point3> points;
  std::vector<Marker> references;  ///< one a point
  std::vector<MeditCell> triangles, quadrilaterals, tetrahedra;
  std::map<Marker, std::string> marker_names;  ///< from leading comments "# marker 2 farfield"
  std::vector<std::string> warnings;           ///< sections that were passed over
};

/// Sections in any order; entries may span lines; # starts a comment.
/// throws InputError with the line: a file of the plane, a keyword that is none, hexahedra, prisms, pyramids and cells
/// of higher order, numbers below 1, a file cut short
[[nodiscard]] MeditData parse_medit_data(std::string_view text, const std::string& source);

}  // namespace leonhard::io
