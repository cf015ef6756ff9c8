// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/io/soup/mesh_soup.hpp"

namespace leonhard::io {

/// What a file states as a mesh of a dimension, format by extension.
/// throws  InputError as the formats' readers do, and for an unknown extension
template <int Dim>
[[nodiscard]] MeshSoup<Dim> read_soup(const std::filesystem::path& path, const ReadOptions& options);

/// The same of the dimension that the contents have. One pass over the file.
[[nodiscard]] AnySoup read_any_soup(const std::filesystem::path& path, const ReadOptions& options);

/// What read_soup knows; dimension 2 or 3.
[[nodiscard]] const std::vector<std::string>& soup_extensions(int dimension);

}  // namespace leonhard::io
