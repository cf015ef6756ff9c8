// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "leonhard/mesh/pslg.hpp"

namespace leonhard::io {

/// Read a planar straight-line graph, format by extension: .poly (Triangle's; points may be in the .node file
/// of the same name when the .poly declares 0 of them).
///
/// throws InputError naming file and line: file missing, empty or cut short, unknown extension, NaN, letters
/// among numbers, point numbers out of range
[[nodiscard]] Pslg read_pslg(const std::filesystem::path& path);

/// The same, and in words what was left out: segments from a vertex to itself.
[[nodiscard]] Pslg read_pslg(const std::filesystem::path& path, std::vector<std::string>& warnings);

/// Write a planar straight-line graph, format by extension as in read_pslg, to the last bit.
/// throws InputError for an unknown extension, OutputError if the file cannot be written
void write_pslg(const std::filesystem::path& path, const Pslg& pslg);

}  // namespace leonhard::io
