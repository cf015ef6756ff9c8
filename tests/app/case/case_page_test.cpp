// SPDX-License-Identifier: MIT
// The reference page and the code must tell the same.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "leonhard/app/case/case.hpp"
#include "tests/test_files.hpp"

using namespace leonhard::app;

namespace {

std::string page() {
  const std::filesystem::path file = leonhard::test::source_folder() / "docs/case-file.md";
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  REQUIRE_FALSE(text.str().empty());
  return text.str();
}

}  // namespace

TEST_CASE("the_page_has_a_row_with_type_and_default_for_every_key") {
  const std::string text = page();
  for (const KnownKey& known : known_keys()) {
    const std::string row = "| `" + known.key + "` | " + known.type + " | " + known.fallback + " | ";
    INFO("row: ", row);
    CHECK(text.find(row) != std::string::npos);
  }
}

TEST_CASE("the_page_has_no_row_for_a_key_that_the_code_does_not_know") {
  std::set<std::string> known;
  for (const KnownKey& key : known_keys()) known.insert(key.key);
  std::istringstream lines(page());
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string key = line.substr(3, line.find('`', 3) - 3);
    INFO("key: ", key);
    CHECK(known.contains(key));
    ++rows;
  }
  CHECK(rows == known.size());
}

TEST_CASE("the_page's_shortest_case_is_one") {
  const std::string text = page();
  const std::size_t begin = text.find("```toml\n") + 8;
  const Case c = parse_case(text.substr(begin, text.find("```", begin) - begin), "page.toml");
  CHECK(c.bodies.size() == 1);
}

TEST_CASE("every_example_is_a_valid_case") {
  std::size_t examples = 0;
  const std::filesystem::path folder = leonhard::test::source_folder() / "examples";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    INFO("example: ", entry.path().string());
    CHECK_NOTHROW((void)read_case(entry.path()));
    ++examples;
  }
  CHECK(examples >= 4);
}
