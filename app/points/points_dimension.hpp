// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace leonhard::app {

/// Whether a file of points is of the plane (2) or of space (3): by a .node's head; by a column named z in the header of a
/// text of columns, or else by three columns or more in its first line of numbers. JSON is of the plane.
///
/// path    with one of any_point_extensions()
/// throws  InputError if the file is missing or its head cannot be read
/// Reads the first bytes only.
[[nodiscard]] int points_dimension(const std::filesystem::path& path);

}  // namespace leonhard::app
