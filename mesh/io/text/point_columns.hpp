// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace leonhard::io {

/// Coordinates read from columns of text.
struct PointColumns {
  std::vector<double> coordinates;    ///< `dimension` a point, point after point
  std::vector<std::string> warnings;  ///< columns that were left out
};

/// Points as columns of text, one a line: separated by semicolons, by commas or by blanks (the first of the three
/// that a line holds), fields in quotation marks or not, empty lines skipped, # starting a comment.
///
/// One header line is allowed. If it names columns x, y (and z), in either case, these are read and the others left
/// out, which a warning tells. Otherwise coordinates come first; where further columns (colours, intensities) are expected
/// they are left out with a warning, every line having as many, else every line has exactly `dimension` columns.
///
/// dimension  2 or 3
/// further    whether columns behind the coordinates are expected
/// source     names the text in errors
/// throws     InputError naming file and line: too few or too many columns, an empty field, letters, NaN, infinities,
///            no point at all, a binary file
[[nodiscard]] PointColumns parse_point_columns(std::string_view text, const std::string& source,
                                               std::size_t dimension, bool further = false);

}  // namespace leonhard::io
