// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program.hpp"

using leonhard::test::Ran;
using leonhard::test::run;
using leonhard::test::ScratchFolder;
using leonhard::test::text_of;
using nlohmann::json;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Nine points of a grid, the middle one twice.
const std::string grid = "0 0\n1 0\n2 0\n0 1\n1 1\n2 1\n0 2\n1 2\n2 2\n1 1\n";

}  // namespace

TEST_CASE("voronoi_reports_the_diagram_and_areas_that_add_up_to_the_box") {
  const ScratchFolder scratch;
  scratch.write("grid.xy", grid);
  const Ran ran = run("voronoi grid.xy --box=-0.5,-0.5,2.5,2.5 -o cells.json --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["sites"] == 9);
  CHECK(report["duplicates"] == 1);
  CHECK(report["unbounded_cells"] == 8);
  CHECK(report["vertices"] == 4);
  CHECK(report["edges"] == 12);
  CHECK(report["area_sum"] == 9.0);
  const json cells = json::parse(text_of(scratch.path() / "cells.json"))["cells"];
  REQUIRE(cells.size() == 9);
  for (const json& cell : cells) {
    CHECK(cell["area"] == 1.0);
    CHECK(cell["corners"].size() == 4);
    CHECK(cell["unbounded"] == (cell["site"] != 4));
  }
}

TEST_CASE("voronoi_draws_pictures_and_writes_grids_of_polygons") {
  const ScratchFolder scratch;
  scratch.write("grid.xy", grid);
  for (const std::string arguments : {"a.png --sites", "b.svg --fill area", "c.pdf --title Grid", "d.vtu"}) {
    const Ran ran = run("voronoi grid.xy --size 400,300 -o " + arguments, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK(holds(ran.out, "unbounded cells  8"));
    CHECK(std::filesystem::file_size(scratch.path() / arguments.substr(0, 5)) > 1000);
  }
  CHECK(holds(text_of(scratch.path() / "d.vtu"), "NumberOfCells=\"9\""));
}

TEST_CASE("voronoi_cells_are_cut_to_a_polygon_that_is_not_convex") {
  const ScratchFolder scratch;
  scratch.write("grid.xy", grid);
  scratch.write("ell.wkt", "POLYGON ((0 0, 2 0, 2 1, 1 1, 1 2, 0 2, 0 0))");
  for (const char* output : {"e.png", "e.vtu", "e.json", "e.geojson"}) {
    const Ran ran = run(std::string("voronoi grid.xy --clip ell.wkt --json -o ") + output, scratch.path());
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    const json report = json::parse(ran.out);
    CHECK(report["area_sum"] == 3.0);
    CHECK(report["box_area"] == 3.0);
    CHECK(report["pieces"] == 8);
  }
  scratch.write("frame.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 0), (2 1, 3 1, 3 2, 2 1))");
  const Ran refused = run("voronoi grid.xy --clip frame.wkt", scratch.path());
  CHECK(refused.exit_code == 2);
  CHECK(holds(refused.err, "not one closed outline"));
}

TEST_CASE("one_point_and_collinear_points_have_a_voronoi_diagram") {
  const ScratchFolder scratch;
  scratch.write("one.xy", "3 4\n");
  scratch.write("line.csv", "0,0\n1,0\n2,0\n");
  const json one = json::parse(run("voronoi one.xy --sites --box 0,0,2,2 --json", scratch.path()).out);
  CHECK(one["unbounded_cells"] == 1);
  CHECK(one["area_sum"] == 4.0);
  const json line = json::parse(run("voronoi line.csv --fill area --box 0,0,2,2 --json", scratch.path()).out);
  CHECK(line["vertices"] == 0);
  CHECK(line["edges"] == 2);
  CHECK(line["area_sum"] == 4.0);
}

TEST_CASE("bad_voronoi_input_is_refused_and_no_file_written") {
  const ScratchFolder scratch;
  scratch.write("good.xy", "0 0\n1 0\n0 1\n");
  scratch.write("nan.xy", "0 0\n1 nan\n");
  const std::pair<const char*, const char*> cases[] = {{"nan.xy", "nan.xy:2"},
                                                       {"missing.xy", "does not exist"},
                                                       {"good.xy --box 1,0,0,1", "--box: 1,0,0,1 is no box"},
                                                       {"good.xy --box=0,0,1,inf", "is no box"},
                                                       {"good.xy -o out.su2", "known are"},
                                                       {"good.su2", "no extension of a points file"}};
  for (const auto& [line, words] : cases) {
    const auto& arguments = line;  // clang 14 captures no binding
    CAPTURE(arguments);
    const Ran ran = run(std::string("voronoi ") + arguments, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 2);
    CHECK(holds(ran.err, words));
  }
  CHECK(run("voronoi good.xy --box 1,2,3", scratch.path()).exit_code == 1);
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "voronoi.png"));
}
