// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/colour.hpp"
#include "leonhard/mesh/draw/picture.hpp"

namespace leonhard::draw {

/// How a field is drawn: draw_field of mesh_picture.hpp.
struct FieldOptions {
  PictureSize size{};
  View view{};
  std::string title{};
  std::string x_label = "x", y_label = "y";
  std::string value_label{};  ///< beside the colour bar, unit included
  ColourMap colour_map = ColourMap::sequential;
  std::optional<Range> value_range{};  ///< default: the values in view; values beyond get the end colours
  /// About how many, 1 to 200: levels are 1, 2, 2.5 or 5 times a power of ten apart, on multiples of that, or
  /// half-way between them where much of the picture is a plateau on such a value (a free stream of Mach 2).
  int bands = 20;
  std::vector<double>
      levels{};  ///< or the levels themselves, strictly rising; those beyond the range do not show
  bool contour_lines = true;
  /// One value a vertex of another field whose contour lines, at `line_levels`, are drawn in place of this one's: streamlines over
  /// pressures, say.
  std::vector<double> lines_of{};
  std::vector<double> line_levels{};     ///< strictly rising
  std::optional<double> dashed_below{};  ///< contour lines of levels below this value are dashed
  bool show_mesh = false;
};

}  // namespace leonhard::draw
