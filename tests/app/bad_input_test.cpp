// SPDX-License-Identifier: MIT
// Every bad input ends with exit code 2, a message that names the culprit, and no file written.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/app/program.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;

namespace {

const std::string flow = "[flow]\nmach = 0.5\n";
const std::string naca = "[[body]]\nnaca = \"0012\"\nspacing = 0.05\n[farfield]\ndistance = 10\n";

/// A diamond as airfoil coordinates, with one line replaced.
std::string airfoil(const std::string& instead = {}, std::size_t at = 0) {
  std::vector<std::string> lines{"diamond", "1.0 0.0",   "0.7 0.05",  "0.4 0.07",  "0.1 0.04",
                                 "0.0 0.0", "0.1 -0.04", "0.4 -0.07", "0.7 -0.05", "1.0 0.0"};
  if (!instead.empty()) lines[at] = instead;
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

std::string body_file(const std::string& name) {
  return "[[body]]\nname = \"wing\"\nfile = \"" + name + "\"\n";
}

/// A square of two triangles as an SU2 mesh, with one piece of its text replaced.
std::string square_su2(const std::string& what = {}, const std::string& by = {}) {
  std::string text =
      "NDIME= 2\nNELEM= 2\n5 0 1 2 0\n5 0 2 3 1\nNPOIN= 4\n0.0 0.0 0\n1.0 0.0 1\n1.0 1.0 2\n0.0 1.0 3\n"
      "NMARK= 1\nMARKER_TAG= outer\nMARKER_ELEMS= 4\n3 0 1\n3 1 2\n3 2 3\n3 3 0\n";
  if (!what.empty()) {
    REQUIRE(text.find(what) != std::string::npos);
    text.replace(text.find(what), what.size(), by);
  }
  return text;
}

const std::string mesh_case = "mesh = \"square.su2\"\n" + flow + "[boundary.outer]\nkind = \"far-field\"\n";

/// Solve a case; expect code 2, all words in the message, and nothing new in the folder.
void refused(const ScratchFolder& scratch, const std::string& case_text,
             const std::vector<std::string>& words) {
  scratch.write("case.toml", case_text);
  const auto ran = run("solve case.toml -o results", scratch.path());
  CAPTURE(ran.err);
  CHECK(ran.exit_code == 2);
  CHECK(ran.out.empty());
  for (const std::string& word : words)
    CHECK_MESSAGE(ran.err.find(word) != std::string::npos, "missing: ", word);
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "results"));
}

}  // namespace

TEST_CASE("a_missing_case_file_is_named") {
  const ScratchFolder scratch;
  const auto ran = run("solve nowhere.toml", scratch.path());
  CHECK(ran.exit_code == 2);
  CHECK(ran.err.find("nowhere.toml") != std::string::npos);
}

TEST_CASE("bad_case_files_are_refused_with_line_and_key") {
  const ScratchFolder scratch;
  refused(scratch, "", {"case.toml"});
  refused(scratch, "[flow]\nmach = -0.5\n" + naca, {"case.toml:2", "mach"});
  refused(scratch, "[flow]\nmach = \"fast\"\n" + naca, {"case.toml:2", "mach", "number"});
  refused(scratch, "[flow]\nmach = nan\n" + naca, {"case.toml:2", "mach"});
  refused(scratch, "[flow]\nmacht = 0.5\n" + naca, {"macht", "mach"});
  refused(scratch, "[flow]\nmach = 0.5\nalpha = 2\n" + naca, {"case.toml:3", "alpha", "alpha_deg"});
  refused(scratch, flow + "[solvr]\norder = 2\n" + naca, {"case.toml:3", "solvr", "solver"});
  refused(scratch, flow + "[solver]\nlimiter = \"venkat\"\n" + naca,
          {"case.toml:4", "venkat", "venkatakrishnan"});
  refused(scratch, flow + naca + "[boundary.wall]\nkind = \"slip-wall\"\n", {"wall"});
  refused(scratch, flow, {"body"});
  refused(scratch, "[flow\nmach = 0.5\n", {"case.toml:1"});
}

TEST_CASE("bad_airfoils_are_refused_with_file_and_line") {
  const ScratchFolder scratch;
  const auto with = [&](const std::string& text, const std::vector<std::string>& words) {
    scratch.write("wing.dat", text);
    refused(scratch, flow + body_file("wing.dat"), words);
  };
  refused(scratch, flow + body_file("nowhere.dat"), {"nowhere.dat"});
  with("", {"wing.dat", "empty"});
  with(airfoil("0.4 seven", 3), {"wing.dat:4", "seven"});
  with(airfoil("0.4 nan", 3), {"wing.dat:4", "nan"});
  with(airfoil("0.4 -0.2", 3), {"wing.dat", "cross"});  // the upper side dips through the lower
  with("open\n1.0 0.0\n0.7 0.05\n0.4 0.07\n0.1 0.04\n0.0 0.0\n0.1 -0.04\n", {"wing.dat", "open"});
}

TEST_CASE("bodies_that_do_not_fit_together_are_refused_by_name") {
  const ScratchFolder scratch;
  const auto two = [](const std::string& second) {
    return flow + "[[body]]\nname = \"main\"\nnaca = \"0012\"\n[[body]]\nname = \"flap\"\nnaca = \"0012\"\n" +
           second;
  };
  refused(scratch, two("translation = [0.5, 0.0]\n"), {"main", "flap"});
  refused(scratch, two("scale = 0.1\ntranslation = [0.4, 0.0]\n"), {"main", "flap"});  // inside the other
  refused(scratch, two("translation = [1.0, 0.0]\n"), {"main", "flap"});               // touching at a point
  refused(scratch, two("translation = [30.0, 0.0]\n[farfield]\ndistance = 5\ncentre = [0.5, 0.0]\n"),
          {"flap", "far field"});
  refused(scratch, flow + "[[body]]\nnaca = \"0012\"\nscale = 3\n[farfield]\ndistance = 1\n",
          {"body1", "far field"});
}

TEST_CASE("bad_mesh_files_are_refused_with_ids_and_coordinates") {
  const ScratchFolder scratch;
  const auto with = [&](const std::string& text, const std::vector<std::string>& words) {
    scratch.write("square.su2", text);
    refused(scratch, mesh_case, words);
  };
  with(square_su2("5 0 2 3 1", "5 0 2 9 1"), {"square.su2:4", "9"});
  with(square_su2("NELEM= 2\n5 0 1 2 0\n5 0 2 3 1", "NELEM= 1\n5 0 1 2 0"),
       {"square.su2"});  // edges of no cell
  with(square_su2("1.0 1.0 2", "2.0 0.0 2"), {"square.su2", "area"});
  with(square_su2("1.0 1.0 2", "nan 1.0 2"), {"square.su2:8", "nan"});
  with(square_su2("5 0 2 3 1", "77 0 2 3 1"), {"square.su2:4", "77"});
  with(square_su2("3 2 3\n3 3 0\n", ""), {"square.su2"});
  with(square_su2("MARKER_ELEMS= 4", "MARKER_ELEMS= 3"), {"square.su2"});
}

TEST_CASE("markers_and_conditions_must_match_both_ways") {
  const ScratchFolder scratch;
  scratch.write("square.su2", square_su2());
  refused(scratch, "mesh = \"square.su2\"\n" + flow, {"outer", "condition"});
  refused(scratch, mesh_case + "[boundary.inlet]\nkind = \"far-field\"\n", {"inlet", "outer"});
}

TEST_CASE("an_output_folder_that_cannot_be_made_is_refused_before_any_work") {
  const ScratchFolder scratch;
  scratch.write("file", "in the way");
  scratch.write("case.toml", flow + naca);
  const auto ran = run("solve case.toml -o file/results", scratch.path());
  CHECK(ran.exit_code == 2);
  CHECK(ran.err.find("file/results") != std::string::npos);
}

TEST_CASE("a_full_disc_is_named_and_leaves_nothing") {
  const ScratchFolder scratch;
  const auto small = scratch.path() / "small";
  std::filesystem::create_directory(small);
  if (std::system(("mount -t tmpfs -o size=200k tmpfs '" + small.string() + "' 2>/dev/null").c_str()) != 0) {
    MESSAGE("no right to mount a small file system: skipped");
    return;
  }
  scratch.write("case.toml", flow + naca + "[solver]\nmax_iterations = 5\n");
  const auto ran = run("solve case.toml -o small/results", scratch.path());
  const bool left = std::filesystem::exists(small / "results");
  CHECK(std::system(("umount '" + small.string() + "'").c_str()) == 0);
  CAPTURE(ran.err);
  CHECK(ran.exit_code == 2);
  CHECK(ran.err.find("small/results") != std::string::npos);
  CHECK(ran.err.find("No space left") != std::string::npos);
  CHECK_FALSE(left);
}

TEST_CASE("other_subcommands_refuse_bad_files_with_code_2") {
  const ScratchFolder scratch;
  scratch.write("bad.su2", square_su2("5 0 2 3 1", "5 0 2 9 1"));
  scratch.write("good.su2", square_su2());
  scratch.write("bad.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 x 1\n");
  const std::vector<std::pair<std::string, std::string>> table{
      {"check bad.su2", "bad.su2:4"},
      {"check good.xyz", "good.xyz"},
      {"draw bad.su2 -o x.png", "bad.su2:4"},
      {"draw good.su2 -o x.bmp", ".bmp"},
      {"draw good.su2 -o x.png --field mach", "mach"},
      {"draw good.su2 -o x.png --view 1,0,0,1", "--view"},
      {"convert bad.su2 x.vtu", "bad.su2:4"},
      {"convert good.su2 x.docx", ".docx"},
      {"mesh bad.poly -o x.su2", "bad.poly:4"},
      {"mesh nowhere.dat -o x.su2", "nowhere.dat"},
  };
  for (const auto& [line, word] : table) {
    const auto& arguments = line;  // clang 14 captures no binding
    const auto ran = run(arguments, scratch.path());
    CAPTURE(arguments);
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 2);
    CHECK(ran.err.find(word) != std::string::npos);
    for (const char* output : {"x.png", "x.bmp", "x.vtu", "x.docx", "x.su2"}) {
      CHECK_FALSE(std::filesystem::exists(scratch.path() / output));
    }
  }
}

TEST_CASE("wrong_usage_is_code_1") {
  const ScratchFolder scratch;
  for (const char* arguments :
       {"", "slove case.toml", "solve", "solve a.toml --thread 2", "mesh a.poly --min-angle 50"}) {
    CAPTURE(arguments);
    CHECK(run(arguments, scratch.path()).exit_code == 1);
  }
}
