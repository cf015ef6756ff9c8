// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/program.hpp"

using leonhard::test::Ran;
using leonhard::test::run;
using leonhard::test::ScratchFolder;
using leonhard::test::text_of;
using nlohmann::json;

namespace {

/// A path of n vertices in METIS's format.
std::string path_graph(int n) {
  std::string text = std::to_string(n) + " " + std::to_string(n - 1) + "\n";
  for (int v = 1; v <= n; ++v)
    text += (v > 1 ? std::to_string(v - 1) + " " : "") + (v < n ? std::to_string(v + 1) : "") + "\n";
  return text;
}

std::vector<int> numbers_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<int> numbers;
  for (int x; in >> x;) numbers.push_back(x);
  return numbers;
}

}  // namespace

TEST_CASE("partition_of_a_path_cuts_it_between_the_parts_and_writes_one_part_a_line") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph(40));
  const Ran ran = run("partition path.graph -k 4 -o parts.txt --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["outcome"] == "done");
  CHECK(report["cut"] == 3);
  CHECK(report["sizes"] == json({10, 10, 10, 10}));
  CHECK(report["max_components"] == 1);
  const std::vector<int> parts = numbers_of(text_of(scratch.path() / "parts.txt"));
  REQUIRE(parts.size() == 40);
  for (int part = 0; part < 4; ++part) CHECK(std::ranges::count(parts, part) == 10);
}

TEST_CASE("partition_knows_its_methods_and_efforts") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph(30));
  for (const char* method : {"cuthill-mckee", "cuthill-mckee-levels", "spectral", "multilevel --effort low"})
    CHECK(
        run(std::string("partition path.graph -k 3 --quiet --method ") + method, scratch.path()).exit_code ==
        0);
}

TEST_CASE("partition_refuses_what_it_cannot_do_and_says_why") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph(5));
  const auto refused = [&](const std::string& arguments, int exit_code, const std::string& why) {
    const Ran ran = run("partition " + arguments, scratch.path());
    CAPTURE(arguments);
    CAPTURE(ran.err);
    CHECK(ran.exit_code == exit_code);
    CHECK(ran.err.find(why) != std::string::npos);
  };
  refused("path.graph -k 6", 2, "6 parts of 5 vertices");
  refused("path.graph -k 2 -o parts.png", 2, "no triangles");
  refused("path.graph -k 2 -o parts.docx", 2, ".txt");
  refused("path.graph -k 2 --method inertial", 2, "points for 5 vertices");
  refused("missing.graph -k 2", 2, "missing.graph");
  refused("path.graph -k 0", 1, "--parts");
  refused("path.graph -k 2 --method magic", 1, "magic");
}
