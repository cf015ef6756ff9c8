// SPDX-License-Identifier: MIT
#define DOCTEST_CONFIG_IMPLEMENT  // said for itself, as the header may be precompiled, which makes it of the next name otherwise
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "tests/test_files.hpp"

namespace leonhard::test {

std::string data_file(const std::string& name) { return (source_folder() / "tests/data" / name).string(); }
std::filesystem::path source_folder() { return LEONHARD_SOURCE_FOLDER; }

}  // namespace leonhard::test
