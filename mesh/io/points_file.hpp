// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/mesh/point_set.hpp"

namespace leonhard {

/// What a reader of points returns: finite points, duplicates kept, and in words what was left out.
struct PointsFile {
  PointSet set;
  std::vector<std::string> warnings;
};

namespace io {

/// Read points of the plane, format by extension: .node (Triangle's: attributes and markers kept, numbered from 0 or
/// 1), and .xy, .xyz, .csv and .txt as columns (point_columns.hpp); of a .xy further columns are left out.
///
/// throws InputError naming file and line: file missing, empty, cut short or binary, unknown extension, NaN,
/// infinities, letters among numbers, too few columns; a third column that no header explains, as in a .xyz of
/// points of space
[[nodiscard]] PointsFile read_points(const std::filesystem::path& path);

/// Write points, format by extension: .node with attributes and markers, numbered from 0; .xy, .csv, .txt the
/// coordinates alone. To the last bit: read_points gives the same points back.
/// throws InputError for an unknown extension, OutputError if the file cannot be written
void write_points(const std::filesystem::path& path, const PointSet& set);

/// ".node", ".xy", ".xyz", ".csv", ".txt": what read_points knows.
[[nodiscard]] const std::vector<std::string>& point_extensions();

/// The same from texts; source names them in errors.
[[nodiscard]] PointsFile parse_node(std::string_view text, const std::string& source);
[[nodiscard]] PointsFile parse_xy(std::string_view text, const std::string& source, bool further = false);
[[nodiscard]] std::string format_node(const PointSet& set);
/// One point a line, the coordinates separated by `separator`.
[[nodiscard]] std::string format_xy(const PointSet& set, char separator = ' ');

}  // namespace io
}  // namespace leonhard
