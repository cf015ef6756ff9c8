// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/mesh/point_set.hpp"

namespace leonhard {

/// What a reader of points of space returns: finite points, duplicates kept, and in words what was left out.
struct Points3File {
  PointSet3 set;
  std::vector<std::string> warnings;
};

namespace io {

/// Read points of space, format by extension: .node (TetGen's: attributes and markers kept, numbered from 0 or 1);
/// .xyz, .xy, .csv and .txt as three columns (point_columns.hpp); and the vertices of surfaces (surface_file.hpp),
/// those of no polygon included.
///
/// throws InputError naming file, and line or byte: file missing, empty, cut short or binary garbage, unknown
/// extension, NaN, infinities, letters among numbers, too few columns, counts that do not match
[[nodiscard]] Points3File read_points3(const std::filesystem::path& path);

/// Write points, format by extension: .node with attributes and markers, numbered from 0; .xyz, .xy, .csv, .txt the
/// coordinates alone. To the last bit: read_points3 gives the same points back.
/// throws InputError for an unknown extension, OutputError if the file cannot be written
void write_points3(const std::filesystem::path& path, const PointSet3& set);

/// ".node", ".xyz", ... and those of surfaces: what read_points3 knows.
[[nodiscard]] const std::vector<std::string>& point3_extensions();

/// The same from texts; source names them in errors.
[[nodiscard]] Points3File parse_node3(std::string_view text, const std::string& source);
[[nodiscard]] Points3File parse_xyz(std::string_view text, const std::string& source);
[[nodiscard]] std::string format_node3(const PointSet3& set);
/// One point a line, the coordinates separated by `separator`.
[[nodiscard]] std::string format_xyz(const PointSet3& set, char separator = ' ');

}  // namespace io
}  // namespace leonhard
