// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "leonhard/delaunay/algorithm.hpp"
#include "tests/app/program.hpp"

using leonhard::test::Ran;
using leonhard::test::run;
using leonhard::test::ScratchFolder;
using nlohmann::json;

namespace {

/// Twenty-five points of a grid, two of them twice: cocircular ties and duplicates.
const std::string grid = [] {
  std::string text = "x,y\n0,0\n4,4\n";
  for (int i = 0; i < 25; ++i) text += std::to_string(i % 5) + "," + std::to_string(i / 5) + "\n";
  return text;
}();

/// An L of segments: its hull is larger.
const std::string corner =
    "6 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 1 1\n5 1 2\n6 0 2\n6 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 5 1\n5 5 6 1\n6 "
    "6 1 1\n0\n";

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

json report_of(const Ran& ran) {
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  return json::parse(ran.out);
}

}  // namespace

TEST_CASE("triangulate_gives_a_sound_delaunay_mesh_and_reports_duplicates") {
  const ScratchFolder scratch;
  scratch.write("grid.csv", grid);
  const Ran ran = run("triangulate grid.csv -o grid.vtu --json", scratch.path());
  const json report = report_of(ran);
  CHECK(report["outcome"] == "done");
  CHECK(report["points"] == 27);
  CHECK(report["duplicates"] == 2);
  CHECK(report["vertices"] == 25);
  CHECK(report["triangles"] == 32);
  CHECK(report["delaunay"] == true);
  CHECK(report["euler"]["balances"] == true);
  CHECK(report["area"] == 16.0);
  CHECK(report["peak_memory_bytes"] > 0);
  for (const char* stage : {"read", "triangulate", "check", "write", "total"})
    CHECK(report["seconds"].contains(stage));
  CHECK(report["warnings"].size() == 1);
  CHECK(holds(ran.err, "2 points merged"));
  CHECK(report["merged_points"] == json::parse("[[2, 0], [26, 1]]"));
  CHECK(report_of(run("check grid.vtu --json", scratch.path()))["fingerprint"] == report["fingerprint"]);
}

TEST_CASE("every_algorithm_and_every_format_of_points_gives_the_same_mesh") {
  const ScratchFolder scratch;
  scratch.write("p.csv", "0,0\n1,0\n1,1\n0,1\n0.25,0.5\n");
  scratch.write("p.node", "5 2 0 1\n0 0 1 1\n1 0 0 1\n2 1 0 1\n3 1 1 1\n4 0.25 0.5 0\n");
  scratch.write("p.json", "{\"points\": [[0.25, 0.5], [1, 1], [0, 0], [0, 1], [1, 0]]}");
  scratch.write("p.geojson",
                "{\"type\": \"MultiPoint\", \"coordinates\": [[0, 0], [1, 0], [1, 1], [0, 1], [0.25, 0.5]]}");
  const json first = report_of(run("triangulate p.csv --json", scratch.path()));
  for (const std::string file : {"p.node", "p.json", "p.geojson"}) {
    CAPTURE(file);
    CHECK(report_of(run("triangulate " + file + " --json", scratch.path()))["fingerprint"] ==
          first["fingerprint"]);
    CHECK(report_of(run("check " + file + " --json", scratch.path()))["fingerprint"] == first["fingerprint"]);
  }
  std::vector<std::string> ways{"--threads 2 --seed 7"};
  for (const auto& known : leonhard::delaunay::named_algorithms)
    ways.push_back("--algorithm " + std::string(known.name));
  for (const std::string& more : ways)
    CHECK(report_of(run("triangulate p.csv --json " + more, scratch.path()))["fingerprint"] ==
          first["fingerprint"]);
}

TEST_CASE("a_graph_is_carved_to_its_segments_unless_the_hull_is_kept") {
  const ScratchFolder scratch;
  scratch.write("corner.poly", corner);
  CHECK(report_of(run("triangulate corner.poly --json", scratch.path()))["area"] == 3.0);
  CHECK(report_of(run("triangulate corner.poly --convex-hull --json", scratch.path()))["area"] == 3.5);
}

TEST_CASE("segments_that_cross_are_split_unless_the_user_says_otherwise") {
  const ScratchFolder scratch;
  scratch.write("bow.poly", "4 2 0 0\n0 0 0\n1 2 2\n2 2 0\n3 0 2\n4 1\n0 0 1 1\n1 1 2 2\n2 2 3 3\n3 3 0 4\n0\n");
  scratch.write("bow.xy", "0 0\n2 2\n2 0\n0 2\n");
  for (const std::string command : {"triangulate bow.poly --json", "mesh bow.poly --min-angle 0 --json"}) {
    CAPTURE(command);
    const json report = report_of(run(command, scratch.path()));
    CHECK(report["area"] == 2.0);
    CHECK(holds(report["warnings"].dump(), "segments 0 and 2 cross at (1, 1): a point was added there"));
    const Ran refused = run(command + " --crossings reject -o no.su2", scratch.path());
    CHECK(refused.exit_code == 2);
    CHECK(holds(refused.err, "segment 0 (point 0 at (0, 0) to point 1 at (2, 2)) and segment 2"));
    CHECK_FALSE(std::filesystem::exists(scratch.path() / "no.su2"));
  }
  CHECK(report_of(run("triangulate bow.poly --crossings skip --convex-hull --json", scratch.path()))["area"] == 4.0);
  CHECK(report_of(run("check bow.poly --json", scratch.path()))["crossings"] == 1);
  CHECK(run("mesh bow.xy", scratch.path()).exit_code == 2);  // points in order that cross are no outline
  CHECK(run("mesh bow.xy --crossings split", scratch.path()).exit_code == 0);
}

TEST_CASE("points_without_triangles_are_code_3_with_words_and_no_file") {
  const ScratchFolder scratch;
  scratch.write("line.xy", "0 0\n1 1\n2 2\n1 1\n");
  scratch.write("two.xy", "0 0\n1 1\n1 1\n");
  const Ran line = run("triangulate line.xy -o mesh.su2 --json", scratch.path());
  CHECK(line.exit_code == 3);
  CHECK(json::parse(line.out)["outcome"] == "all_collinear");
  CHECK(holds(line.err, "line.xy: no triangles: all 3 distinct points lie exactly on one line"));
  const Ran two = run("triangulate two.xy -o mesh.su2", scratch.path());
  CHECK(two.exit_code == 3);
  CHECK(holds(two.err, "two.xy: no triangles: 2 distinct points"));
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "mesh.su2"));
}

TEST_CASE("check_gives_an_account_of_points") {
  const ScratchFolder scratch;
  scratch.write("grid.csv", grid);
  const json report = report_of(run("check grid.csv --json -o account.json", scratch.path()));
  CHECK(report["points"] == 27);
  CHECK(report["duplicates"] == 2);
  CHECK(report["collinear"] == false);
  CHECK(report["hull_points"] == 16);
  CHECK(report["box"]["high"] == json::array({4.0, 4.0}));
  CHECK(std::filesystem::exists(scratch.path() / "account.json"));
  scratch.write("line.txt", "0 0\n1 3\n2 6\n");
  const json line = report_of(run("check line.txt --json", scratch.path()));
  CHECK(line["collinear"] == true);
  CHECK(line["fingerprint"].is_null());
  CHECK(holds(run("check line.txt", scratch.path()).out, "there is no triangulation"));
}

TEST_CASE("bad_points_are_code_2_with_the_place_and_no_file") {
  const ScratchFolder scratch;
  scratch.write("nan.xy", "0 0\n1 nan\n2 0\n");
  scratch.write("short.csv", "0,0\n1\n");
  scratch.write("empty.txt", "");
  scratch.write("space.xyz", "0 0 0\n1 1 1\n");
  scratch.write("binary.xy", std::string("\0\1\2\3", 4));
  scratch.write("half.json", "[[0, 0], [1");
  scratch.write("cut.node", "3 2 0 0\n1 0 0\n");
  scratch.write("good.xy", "0 0\n1 0\n0 1\n");
  const std::pair<const char*, const char*> cases[] = {{"nan.xy", "nan.xy:2: \"nan\" is not finite"},
                                                       {"short.csv", "short.csv:2: the line has 1 columns"},
                                                       {"empty.txt", "file is empty"},
                                                       {"space.xyz", "space.xyz:1: the line has 3 columns"},
                                                       {"binary.xy", "zero byte"},
                                                       {"half.json", "half.json:1: is no valid JSON"},
                                                       {"cut.node", "cannot hold so many"},
                                                       {"missing.xy", "file does not exist"},
                                                       {"good.xyy", "did you mean"},
                                                       {"good.xy -o mesh.stl", "no extension of a mesh"}};
  for (const auto& [line, words] : cases) {
    const auto& arguments = line;  // clang 14 captures no binding
    CAPTURE(arguments);
    const Ran ran = run(std::string("triangulate ") + arguments, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 2);
    CHECK(holds(ran.err, words));
    CHECK(ran.out.empty());
  }
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "mesh.su2"));
  CHECK(run("triangulate good.xy --algorithm quick", scratch.path()).exit_code == 1);
  CHECK(run("check nan.xy", scratch.path()).exit_code == 2);
}
