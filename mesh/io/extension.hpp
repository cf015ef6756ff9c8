// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace leonhard::io {

/// The path's extension in small letters, which must be one of the known ones.
/// throws InputError that lists them, with a did-you-mean; what is e.g. "mesh"
std::string known_extension(const std::filesystem::path& path, const std::vector<std::string>& known,
                            const std::string& what);

/// A path's extension in small letters.
[[nodiscard]] std::string small_extension(const std::filesystem::path& path);

/// Whether the format of a file, by its extension, carries fields of values at vertices and in cells.
[[nodiscard]] bool carries_fields(const std::filesystem::path& path);

}  // namespace leonhard::io
