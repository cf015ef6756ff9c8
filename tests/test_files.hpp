// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace leonhard::test {

/// The path of a file under tests/data, e.g. "square_with_hole.poly".
[[nodiscard]] std::string data_file(const std::string& name);

/// The root of the source tree, for tests that hold pages and examples against the code.
[[nodiscard]] std::filesystem::path source_folder();

}  // namespace leonhard::test
