// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/io/points_file.hpp"

namespace leonhard::app {

/// Read points of the plane, format by extension: those of io::read_points, and .json and .geojson.
/// throws InputError as io::read_points and parse_points_json do
[[nodiscard]] PointsFile read_any_points(const std::filesystem::path& path);

/// Whether a file name's extension is one of points: a .node counts if there is no .ele of the same name beside it,
/// which would make it a mesh.
[[nodiscard]] bool is_points_file(const std::filesystem::path& path);

/// What read_any_points knows.
[[nodiscard]] const std::vector<std::string>& any_point_extensions();

}  // namespace leonhard::app
