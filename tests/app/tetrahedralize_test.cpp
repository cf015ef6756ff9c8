// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/delaunay/tet_algorithm.hpp"
#include "tests/app/program.hpp"

using leonhard::test::Ran;
using leonhard::test::run;
using leonhard::test::ScratchFolder;
using nlohmann::json;

namespace {

/// Twenty-seven points of a grid, two of them twice: cospherical ties and duplicates.
const std::string grid = [] {
  std::string text = "x,y,z\n0,0,0\n2,2,2\n";
  for (int i = 0; i < 27; ++i) {
    text += std::to_string(i % 3) + "," + std::to_string(i / 3 % 3) + "," + std::to_string(i / 9) + "\n";
  }
  return text;
}();

const std::string octahedron_off =
    "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
    "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";

/// A unit cube of five tetrahedra as an SU2 mesh, with one piece of its text replaced.
std::string cube_su2(const std::string& what = {}, const std::string& by = {}) {
  std::string text =
      "NDIME= 3\nNELEM= 5\n10 0 1 2 4 0\n10 3 2 1 7 1\n10 5 1 4 7 2\n10 6 4 2 7 3\n10 1 2 4 7 4\n"
      "NPOIN= 8\n0 0 0 0\n1 0 0 1\n0 1 0 2\n1 1 0 3\n0 0 1 4\n1 0 1 5\n0 1 1 6\n1 1 1 7\n"
      "NMARK= 2\nMARKER_TAG= bottom\nMARKER_ELEMS= 2\n5 0 2 1\n5 3 1 2\n"
      "MARKER_TAG= rest\nMARKER_ELEMS= 10\n5 0 1 4\n5 0 4 2\n5 3 2 7\n5 3 7 1\n5 5 1 7\n5 5 7 4\n5 5 4 1\n5 "
      "6 7 2\n"
      "5 6 2 4\n5 6 4 7\n";
  if (!what.empty()) {
    REQUIRE(text.find(what) != std::string::npos);
    text.replace(text.find(what), what.size(), by);
  }
  return text;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

json report_of(const Ran& ran) {
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  return json::parse(ran.out);
}

}  // namespace

TEST_CASE("tetrahedralize_gives_a_sound_delaunay_mesh_and_reports_duplicates_and_memory") {
  const ScratchFolder scratch;
  scratch.write("grid.csv", grid);
  const Ran ran = run("tetrahedralize grid.csv -o grid.vtu --json", scratch.path());
  const json report = report_of(ran);
  CHECK(report["outcome"] == "done");
  CHECK(report["points"] == 29);
  CHECK(report["duplicates"] == 2);
  CHECK(report["vertices"] == 27);
  CHECK(report["hull_faces"] == 48);
  CHECK(report["box"]["high"] == json::array({2.0, 2.0, 2.0}));
  CHECK(report["delaunay"] == true);
  CHECK(report["fills_convex_hull"] == true);
  CHECK(report["euler"]["balances"] == true);
  CHECK(report["euler"]["components"] == 1);
  CHECK(report["euler"]["handles"] == 0);
  CHECK(report["euler"]["cavities"] == 0);
  CHECK(report["volume"] == 8.0);
  CHECK(report["volume_within_boundary"] == 8.0);
  CHECK(report["volumes_equal"] == true);
  CHECK(report["expected_memory_bytes"] > 0);
  CHECK(report["peak_memory_bytes"] > 0);
  for (const char* stage : {"read", "tetrahedralize", "check", "write", "total"})
    CHECK(report["seconds"].contains(stage));
  CHECK(holds(ran.err, "29 points, about"));
  CHECK(holds(ran.err, "of memory expected"));
  const json checked = report_of(run("check grid.vtu --json", scratch.path()));
  for (const char* same : {"fingerprint", "tetrahedra", "faces", "edges", "volume"})
    CHECK(checked[same] == report[same]);
}

TEST_CASE("every_algorithm_seed_thread_count_and_output_format_gives_the_same_tetrahedra") {
  const ScratchFolder scratch;
  scratch.write("grid.csv", grid);
  const json first = report_of(run("tetrahedralize grid.csv -o first.vtu --json", scratch.path()));
  std::vector<std::string> ways{"--seed 5 --threads 2"};
  for (const auto& known : leonhard::delaunay::named_tet_algorithms)
    ways.push_back("--algorithm " + std::string(known.name));
  for (const std::string& way : ways) {
    CAPTURE(way);
    const Ran ran = run("tetrahedralize grid.csv --no-check --quiet --json " + way, scratch.path());
    CHECK(report_of(ran)["fingerprint"] == first["fingerprint"]);
    CHECK_FALSE(report_of(ran).contains("euler"));
    CHECK_FALSE(holds(ran.err, "expected"));
  }
  for (const std::string name : {"a.su2", "a.msh", "a.mesh", "a.node"}) {
    CAPTURE(name);
    report_of(run("tetrahedralize grid.csv --json -o " + name, scratch.path()));
    CHECK(report_of(run("check " + name + " --json", scratch.path()))["fingerprint"] == first["fingerprint"]);
  }
}

TEST_CASE("tetrahedralize_prints_its_account_for_people_and_draws_pictures") {
  const ScratchFolder scratch;
  scratch.write("grid.csv", grid);
  for (const std::string name : {"a.png", "a.svg", "a.pdf"}) {
    const Ran ran = run("tetrahedralize grid.csv -o " + name, scratch.path());
    CHECK(ran.exit_code == 0);
    CHECK(holds(ran.out, "29, 2 duplicates merged"));
    CHECK(holds(ran.out, "the whole convex hull is filled"));
    CHECK(holds(ran.out, "0 cavities"));
    CHECK(std::filesystem::file_size(scratch.path() / name) > 1000);
  }
}

TEST_CASE("a_surface_gives_its_vertices_with_a_note_that_facets_are_not_yet_constraints") {
  const ScratchFolder scratch;
  scratch.write("octahedron.off", octahedron_off);
  const Ran ran = run("tetrahedralize octahedron.off -o x.vtu --json", scratch.path());
  const json report = report_of(ran);
  CHECK(report["vertices"] == 6);
  CHECK(report["tetrahedra"] == 4);
  CHECK(report["warnings"].size() == 1);
  CHECK(holds(ran.err, "facets are not yet constraints"));
}

TEST_CASE("points_without_tetrahedra_are_code_3_with_words_that_say_what_to_do_and_no_file") {
  const ScratchFolder scratch;
  scratch.write("three.xyz", "0 0 0\n1 0 0\n0 1 0\n0 1 -0\n");
  scratch.write("line.xyz", "0 0 0\n1 2 3\n2 4 6\n3 6 9\n-1 -2 -3\n");
  scratch.write("plane.xyz", "0 0 1\n1 0 1\n0 1 1\n1 1 1\n0.3 0.7 1\n");
  const std::vector<std::array<std::string, 3>> cases{
      {"three.xyz", "too_few_points", "3 distinct points, a tetrahedron needs four"},
      {"line.xyz", "all_collinear", "all 5 distinct points lie exactly on one line; add two points off it"},
      {"plane.xyz", "all_coplanar",
       "all 5 distinct points lie exactly in one plane; add a point off it, or give two"}};
  for (const auto& [points_file, outcome, words] : cases) {
    const auto& file = points_file;  // clang 14 captures no binding
    CAPTURE(file);
    const Ran ran = run("tetrahedralize " + file + " -o x.vtu --json", scratch.path());
    CHECK(ran.exit_code == 3);
    const json report = json::parse(ran.out);
    CHECK(report["outcome"] == outcome);
    CHECK(holds(report["words"].get<std::string>(), words));
    CHECK(holds(ran.err, words));
    CHECK_FALSE(std::filesystem::exists(scratch.path() / "x.vtu"));
    const json checked = report_of(run("check " + file + " --json", scratch.path()));
    CHECK(checked["outcome"] == outcome);
    CHECK(checked["fingerprint"].is_null());
  }
}

TEST_CASE("check_gives_points_of_space_their_account") {
  const ScratchFolder scratch;
  scratch.write("grid.csv", grid);
  scratch.write("grid.node", "5 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 0.25 0.25 0.25\n");
  const json report = report_of(run("check grid.csv --json", scratch.path()));
  CHECK(report["points"] == 29);
  CHECK(report["duplicates"] == 2);
  CHECK(report["hull_faces"] == 48);
  CHECK(report["hull_points"] == 26);
  CHECK(report["fingerprint"] ==
        report_of(run("tetrahedralize grid.csv --json --quiet", scratch.path()))["fingerprint"]);
  const json node = report_of(run("check grid.node --json", scratch.path()));
  CHECK(node["tetrahedra"] == 4);
  CHECK(node["hull_points"] == 4);
  CHECK(holds(run("check grid.csv", scratch.path()).out, "48 faces, 26 points"));
  // Two columns, or three without a z in the header, stay points of the plane.
  scratch.write("flat.csv", "x,y,value\n0,0,7\n1,0,8\n0,1,9\n");
  CHECK(report_of(run("check flat.csv --json", scratch.path()))["triangles"] == 1);
}

TEST_CASE("check_gives_a_tetrahedral_mesh_its_account_with_markers") {
  const ScratchFolder scratch;
  scratch.write("cube.su2", cube_su2());
  const json report = report_of(run("check cube.su2 --json", scratch.path()));
  CHECK(report["vertices"] == 8);
  CHECK(report["edges"] == 18);
  CHECK(report["faces"] == 16);
  CHECK(report["tetrahedra"] == 5);
  CHECK(report["valid"] == true);
  CHECK(report["euler"]["balances"] == true);
  CHECK(report["euler"]["characteristic"] == 1);
  CHECK(report["volume"] == 1.0);
  CHECK(report["min_dihedral_deg"].get<double>() == doctest::Approx(54.7356));
  CHECK(report["boundary"].size() == 2);
  CHECK(report["boundary"][0]["name"] == "bottom");
  CHECK(report["boundary"][0]["faces"] == 2);
  CHECK(report["boundary"][0]["area"] == 1.0);
  const Ran text = run("check cube.su2", scratch.path());
  for (const char* words :
       {"1 component(s), 0 handle(s), 0 cavities", "bottom (marker", "equal, exactly", "="})
    CHECK(holds(text.out, words));
}

TEST_CASE("draw_shows_meshes_of_space_by_every_colour_cut_and_view") {
  const ScratchFolder scratch;
  scratch.write("cube.su2", cube_su2());
  for (const std::string options :
       {"", "--what markers", "--what regions --cut none", "--what quality --section --cut x=0.3",
        "--what partition --parts 2 --cut none", "--cut z", "--cut \"x<0.25\"",
        "--cut 1,0,1,1.2 --perspective 20", "--view 30,-20 --cut none --title Cube"}) {
    CAPTURE(options);
    const Ran ran = run("draw cube.su2 -o x.png --size 400,250 " + options, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK(std::filesystem::remove(scratch.path() / "x.png"));
  }
  CHECK(run("convert cube.su2 cube.vtu", scratch.path()).exit_code == 0);
  CHECK(run("draw cube.vtu -o x.png --field marker --cut none", scratch.path()).exit_code == 0);
  CHECK(std::filesystem::exists(scratch.path() / "x.png"));
  const Ran missing = run("draw cube.vtu -o y.png --field mach", scratch.path());
  CHECK(missing.exit_code == 2);
  CHECK(holds(missing.err, "it has marker"));
}

TEST_CASE("convert_carries_tetrahedra_markers_and_names_between_formats") {
  const ScratchFolder scratch;
  scratch.write("cube.su2", cube_su2());
  const json first = report_of(run("check cube.su2 --json", scratch.path()));
  for (const std::string name : {"a.vtu", "a.msh", "a.mesh", "a.node"}) {
    CAPTURE(name);
    const json said = report_of(run("convert cube.su2 --json --quiet " + name, scratch.path()));
    CHECK(said["tetrahedra"] == 5);
    const json copy = report_of(run("check " + name + " --json", scratch.path()));
    CHECK(copy["fingerprint"] == first["fingerprint"]);
    CHECK(copy["boundary"].size() == 2);
  }
}

TEST_CASE("bad_points_and_meshes_of_space_are_code_2_with_the_place_and_no_file") {
  const ScratchFolder scratch;
  scratch.write("nan.xyz", "0 0 0\n1 nan 0\n2 0 0\n");
  scratch.write("inf.xyz", "0 0 0\n1 0 inf\n");
  scratch.write("short.csv", "0,0,0\n1,2\n");
  scratch.write("flat.xy", "0 0\n1 0\n0 1\n");
  scratch.write("empty.xyz", "");
  scratch.write("cut.node", "9 3 0 0\n1 0 0 0\n");
  scratch.write("good.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  scratch.write("cube.su2", cube_su2());
  scratch.write("inverted.su2", cube_su2("10 1 2 4 7 4", "10 2 1 4 7 4"));
  scratch.write("flat.su2", cube_su2("1 1 1 7", "1 1 0 7"));
  scratch.write("range.su2", cube_su2("10 6 4 2 7 3", "10 6 4 2 8 3"));
  scratch.write("nan.su2", cube_su2("0 1 1 6", "0 nan 1 6"));
  scratch.write("square.su2",
                "NDIME= 2\nNELEM= 2\n5 0 1 2 0\n5 0 2 3 1\nNPOIN= 4\n0 0 0\n1 0 1\n1 1 2\n0 1 3\n"
                "NMARK= 1\nMARKER_TAG= o\nMARKER_ELEMS= 4\n3 0 1\n3 1 2\n3 2 3\n3 3 0\n");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"tetrahedralize nan.xyz -o x.vtu", "nan.xyz:2: \"nan\" is not finite"},
      {"tetrahedralize inf.xyz -o x.vtu", "inf.xyz:2"},
      {"tetrahedralize short.csv -o x.vtu", "short.csv:2"},
      {"tetrahedralize flat.xy -o x.vtu", "flat.xy:1"},
      {"tetrahedralize empty.xyz -o x.vtu", "empty.xyz"},
      {"tetrahedralize cut.node -o x.vtu", "cut.node"},
      {"tetrahedralize missing.xyz -o x.vtu", "file does not exist"},
      {"tetrahedralize good.xyq -o x.vtu", "good.xyq"},
      {"tetrahedralize good.xyz -o x.docx", ".docx"},
      {"tetrahedralize good.xyz -o x.vtu --memory-limit 1", "memory"},
      {"check nan.xyz", "nan.xyz:2"},
      {"check missing.xyz", "file does not exist"},
      {"check flat.su2", "flat.su2"},
      {"check range.su2", "range.su2:6"},
      {"check nan.su2", "nan.su2"},
      {"check missing.mesh", "missing.mesh"},
      {"draw flat.su2 -o x.png", "flat.su2"},
      {"draw cube.su2 -o x.bmp", ".bmp"},
      {"draw cube.su2 -o x.png --cut w=1", "--cut: 'w=1' is no plane"},
      {"draw cube.su2 -o x.png --cut x=abc", "--cut"},
      {"draw cube.su2 -o x.png --cut 0,0,0,1", "--cut"},
      {"draw cube.su2 -o x.png --cut 1,2,3", "--cut"},
      {"draw cube.su2 -o x.png --cut \"x>-1\"", "cut: it leaves nothing"},
      {"draw cube.su2 -o x.png --view 0,0,1,1", "--view: 4 numbers for a picture of space"},
      {"draw cube.su2 -o x.png --view 0,91", "elevation of 91"},
      {"draw cube.su2 -o x.png --what matrix", "--what matrix"},
      {"draw cube.su2 -o x.png --field mach", "mach"},
      {"draw square.su2 -o x.png --cut x=0.5", "--cut: square.su2 is a mesh of the plane"},
      {"draw square.su2 -o x.png --section", "--section"},
      {"draw square.su2 -o x.png --what markers", "--what markers"},
      {"draw square.su2 -o x.png --view 1,2", "--view: 2 numbers for a picture of the plane"},
      {"convert flat.su2 x.vtu", "flat.su2"},
      {"convert cube.su2 x.docx", ".docx"},
      {"convert cube.su2 x.poly", ".poly is written for meshes of the plane only"},
      {"convert missing.su2 x.vtu", "missing.su2"},
  };
  for (const auto& [line, words] : cases) {
    const auto& arguments = line;  // clang 14 captures no binding
    CAPTURE(arguments);
    const Ran ran = run(arguments, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 2);
    CHECK(holds(ran.err, words));
    CHECK(ran.out.empty());
    for (const char* output : {"x.vtu", "x.png", "x.bmp", "x.docx", "x.poly", "x.mesh", "mesh.vtu"})
      CHECK_FALSE(std::filesystem::exists(scratch.path() / output));
  }
  const Ran turned = run("check inverted.su2", scratch.path());
  CHECK(turned.exit_code == 0);
  CHECK(holds(turned.out + turned.err, "turned over"));
  CHECK(run("tetrahedralize good.xyz --algorithm quick", scratch.path()).exit_code == 1);
  CHECK(run("tetrahedralize", scratch.path()).exit_code == 1);
  CHECK(run("draw cube.su2 -o x.png --what nothing", scratch.path()).exit_code == 1);
  CHECK(run("tetrahedralize --help", scratch.path()).exit_code == 0);
}
