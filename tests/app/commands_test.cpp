// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;
using nlohmann::json;

namespace {

/// A 4 x 4 square with a square hole, whole numbers.
const char* const frame =
    "8 2 0 1\n1 0 0 1\n2 4 0 1\n3 4 4 1\n4 0 4 1\n5 1 1 2\n6 3 1 2\n7 3 3 2\n8 1 3 2\n"
    "8 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 5 6 2\n6 6 7 2\n7 7 8 2\n8 8 5 2\n1\n1 2 2\n";

}  // namespace

TEST_CASE("mesh_makes_a_sound_mesh_that_check_convert_and_draw_can_read") {
  const ScratchFolder scratch;
  scratch.write("frame.poly", frame);
  const auto meshed = run("mesh frame.poly --size 0.5 --min-angle 30 -o frame.su2 --json", scratch.path());
  CAPTURE(meshed.err);
  REQUIRE(meshed.exit_code == 0);
  const json mesh = json::parse(meshed.out);
  CHECK(mesh["euler"]["balances"] == true);
  CHECK(mesh["euler"]["holes"] == 1);
  CHECK(mesh["delaunay"] == true);
  CHECK(mesh["min_angle_deg"] >= 30.0);
  CHECK(mesh["area"] == 12.0);  // 4 x 4 less 2 x 2
  CHECK(mesh["refinement"]["outcome"] == "achieved");

  const json checked = json::parse(run("check frame.su2 --json", scratch.path()).out);
  CHECK(checked["fingerprint"] == mesh["fingerprint"]);
  CHECK(checked["boundary"].size() == 2);

  for (const std::string format : {"vtu", "node", "su2"}) {
    CHECK(run("convert frame.su2 copy." + format + " --quiet", scratch.path()).exit_code == 0);
    const auto copy = run("check copy." + format + " --json", scratch.path());
    CHECK(json::parse(copy.out)["fingerprint"] == mesh["fingerprint"]);
  }
  for (const std::string picture :
       {"a.png", "b.png --what quality", "c.svg --what partition --parts 3", "d.pdf --what matrix"}) {
    const auto drawn = run("draw frame.su2 -o " + picture, scratch.path());
    CAPTURE(drawn.err);
    CHECK(drawn.exit_code == 0);
    CHECK(std::filesystem::file_size(scratch.path() / picture.substr(0, 5)) > 1000);
  }
}

TEST_CASE("convert_keeps_fields_where_the_format_has_a_place_and_says_what_it_leaves_out") {
  const ScratchFolder scratch;
  scratch.write("frame.poly", frame);
  REQUIRE(run("mesh frame.poly --size 0.5 -o frame.su2", scratch.path()).exit_code == 0);
  REQUIRE(run("partition frame.su2 -k 3 --of vertices -o parts.vtu", scratch.path()).exit_code == 0);
  CHECK(run("convert parts.vtu parts.msh", scratch.path()).err.find("left behind") == std::string::npos);
  CHECK(run("convert parts.msh back.vtu", scratch.path()).exit_code == 0);
  CHECK(run("draw back.vtu --field part -o part.png", scratch.path()).exit_code == 0);
  const auto plain = run("convert parts.vtu plain.su2", scratch.path());
  CHECK(plain.exit_code == 0);
  CHECK(plain.err.find("left behind: the field \"part\"") != std::string::npos);
}

TEST_CASE("regress_a_graph_is_meshed_without_any_size") {
  const ScratchFolder scratch;
  scratch.write("frame.poly", frame);
  const auto meshed = run("mesh frame.poly -o frame.su2 --json", scratch.path());
  CAPTURE(meshed.err);
  REQUIRE(meshed.exit_code == 0);
  CHECK(json::parse(meshed.out)["area"] == 12.0);
}

TEST_CASE("mesh_tells_programs_its_warnings_and_which_points_were_merged") {
  const ScratchFolder scratch;
  scratch.write("twice.poly",
                "5 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 2 0\n4 1\n0 0 1 1\n1 4 2 1\n2 2 3 1\n3 3 0 1\n0\n");
  const auto meshed = run("mesh twice.poly -o twice.su2 --json", scratch.path());
  CAPTURE(meshed.err);
  REQUIRE(meshed.exit_code == 0);
  const json report = json::parse(meshed.out);
  CHECK(report["input"] == "twice.poly");
  CHECK(report["output"] == "twice.su2");
  CHECK(report["merged_points"] == json::parse("[[4, 1]]"));
  REQUIRE(report["warnings"].size() == 1);
  CHECK(report["warnings"][0].get<std::string>().find("point 4 with point 1") != std::string::npos);
}

TEST_CASE("a_spent_vertex_budget_is_code_3_and_the_mesh_is_still_sound") {
  const ScratchFolder scratch;
  scratch.write("frame.poly", frame);
  const auto meshed =
      run("mesh frame.poly --size 0.05 --max-vertices 200 -o frame.su2 --json", scratch.path());
  CHECK(meshed.exit_code == 3);
  CHECK(json::parse(meshed.out)["euler"]["balances"] == true);
  CHECK(meshed.err.find("200") != std::string::npos);
}

TEST_CASE("help_and_version_are_code_0") {
  const ScratchFolder scratch;
  for (const char* arguments :
       {"--help", "--version", "solve --help", "mesh --help", "check --help", "draw --help", "convert --help",
        "triangulate --help", "voronoi --help", "order --help", "partition --help", "communicate --help"}) {
    const auto ran = run(arguments, scratch.path());
    CAPTURE(arguments);
    CHECK(ran.exit_code == 0);
    CHECK_FALSE(ran.out.empty());
  }
}
