// SPDX-License-Identifier: MIT
// The second name implies the first only where doctest's header is read afresh; it may be precompiled.
#define DOCTEST_CONFIG_IMPLEMENT
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "tests/test_files.hpp"

namespace leonhard::test {

std::string data_file(const std::string& name) { return (source_folder() / "tests/data" / name).string(); }
std::filesystem::path source_folder() { return LEONHARD_SOURCE_FOLDER; }

}  // namespace leonhard::test
