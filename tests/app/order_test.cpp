// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "leonhard/graph/order.hpp"
#include "tests/app/beam.hpp"
#include "tests/app/program.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;
using leonhard::test::text_of;
using nlohmann::json;

namespace {

/// A path through six vertices in confused sequence: 1-4-2-6-3-5.
const std::string path_graph = "6 5\n4\n4 6\n5 6\n1 2\n3\n2 3\n";

/// A square of two triangles.
const std::string square =
    "NDIME= 2\nNELEM= 2\n5 0 1 2 0\n5 0 2 3 1\nNPOIN= 4\n0.0 0.0 0\n1.0 0.0 1\n1.0 1.0 2\n0.0 1.0 3\n"
    "NMARK= 1\nMARKER_TAG= outer\nMARKER_ELEMS= 4\n3 0 1\n3 1 2\n3 2 3\n3 3 0\n";

}  // namespace

TEST_CASE("order_numbers_a_graph_and_writes_it_again") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph);
  const auto ran = run("order path.graph -o narrow.graph --picture p.png --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["vertices"] == 6);
  CHECK(report["edges"] == 5);
  CHECK(report["components"] == 1);
  REQUIRE(report["orderings"].size() == 2);
  CHECK(report["orderings"][0]["method"] == "natural");
  CHECK(report["orderings"][0]["bandwidth"] == 4);
  CHECK(report["orderings"][1]["bandwidth"] == 1);
  CHECK(report["orderings"][1]["fill"] == 0);
  CHECK(std::filesystem::file_size(scratch.path() / "p.png") > 1000);
  const json again = json::parse(run("order narrow.graph --method natural --json", scratch.path()).out);
  CHECK(again["orderings"][0]["bandwidth"] == 1);

  CHECK(run("order path.graph --method cuthill-mckee -o order.txt --quiet", scratch.path()).exit_code == 0);
  const std::string order = text_of(scratch.path() / "order.txt");
  CHECK((order == "0\n3\n1\n5\n2\n4\n" || order == "4\n2\n5\n1\n3\n0\n"));
}

TEST_CASE("order_compares_all_methods") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph);
  scratch.write("path.xyz", "0 0\n2 0\n4 0\n1 0\n5 0\n3 0\n");
  const auto ran = run("order path.graph --method all --picture p.svg --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  const auto& methods = leonhard::graph::named_order_methods;
  const auto ours = std::ranges::count(methods, false, &leonhard::graph::NamedOrderMethod::of_boost);
  CHECK(report["orderings"].size() == static_cast<std::size_t>(ours));
  for (const json& line : report["orderings"])
    if (line["method"] == "hilbert") CHECK(line["bandwidth"] == 1);
  const auto table = run("order path.graph --method all", scratch.path());
  for (const auto& known : methods) CHECK((table.out.find(known.name) == std::string::npos) == known.of_boost);
  for (const auto& known : methods) {
    if (!known.of_boost) continue;
    const auto alone = run("order path.graph --method " + std::string(known.name), scratch.path());
    CHECK(alone.exit_code == 0);
    CHECK(alone.out.find(known.name) != std::string::npos);
  }
}

TEST_CASE("order_renumbers_a_mesh_and_keeps_its_fingerprint") {
  const ScratchFolder scratch;
  scratch.write("square.su2", square);
  for (const char* arguments : {"order square.su2 --method hilbert -o new.su2 --quiet",
                                "order square.su2 --cells -o cells.txt --quiet",
                                "order square.su2 --method rosen --start sloan -o vertices.graph --quiet"}) {
    const auto ran = run(arguments, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
  }
  const json before = json::parse(run("check square.su2 --json", scratch.path()).out),
             after = json::parse(run("check new.su2 --json", scratch.path()).out);
  CHECK(before["fingerprint"] == after["fingerprint"]);
  CHECK(text_of(scratch.path() / "cells.txt").size() == 4);
  CHECK(text_of(scratch.path() / "vertices.graph").starts_with("4 5\n"));
}

TEST_CASE("order_renumbers_a_mesh_of_tetrahedra_and_keeps_its_fingerprint") {
  const ScratchFolder scratch;
  scratch.write("beam.mesh", leonhard::test::beam(6));
  for (const char* arguments : {"order beam.mesh --method spectral -o new.vtu --quiet",
                                "order beam.mesh --method hilbert --cells -o cells.txt --quiet",
                                "order beam.mesh -o vertices.graph --picture beam.png --quiet"}) {
    const auto ran = run(arguments, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
  }
  const json before = json::parse(run("check beam.mesh --json", scratch.path()).out),
             after = json::parse(run("check new.vtu --json", scratch.path()).out);
  CHECK(before["fingerprint"] == after["fingerprint"]);
  const json cost = json::parse(run("order new.vtu --json --method natural", scratch.path()).out);
  const json ordered = json::parse(run("order beam.mesh --json --method spectral", scratch.path()).out);
  CHECK(cost["vertices"] == 28);
  CHECK(cost["orderings"][0]["bandwidth"] == ordered["orderings"][1]["bandwidth"]);
  CHECK(text_of(scratch.path() / "vertices.graph").starts_with("28 "));
  const std::string cells = text_of(scratch.path() / "cells.txt");
  CHECK(std::count(cells.begin(), cells.end(), '\n') == 36);
}

TEST_CASE("order_refuses_bad_input_and_writes_nothing") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph);
  scratch.write("bad.graph", "2 1\n2\n\n");
  scratch.write("bad.mtx", "%%MatrixMarket matrix coordinate real general\n2 3 0\n");
  scratch.write("bad.csv", "from,to\n0,1\n1\n");
  scratch.write("far.graph", path_graph);
  scratch.write("far.xyz", "0 0\n");
  scratch.write("square.su2", square);
  scratch.write("beam.mesh", leonhard::test::beam(1));
  scratch.write("cut.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n9\n0 0 0 0\n");
  const std::vector<std::pair<std::string, std::string>> table{
      {"order bad.graph -o x.txt", "bad.graph:2: vertex 1 has an edge to vertex 2"},
      {"order bad.mtx -o x.txt", "bad.mtx:2: the matrix has 2 rows and 3 columns"},
      {"order bad.csv -o x.txt", "bad.csv:3: line ends"},
      {"order far.graph -o x.txt", "far.xyz:1: 1 vertices have coordinates"},
      {"order nowhere.graph -o x.txt", "does not exist"},
      {"order path.grph -o x.txt", "did you mean"},
      {"order path.graph --method hilbert -o x.txt", "0 points for 6 vertices"},
      {"order path.graph --method rosen --start rosen -o x.txt", "rosen cannot start from rosen"},
      {"order path.graph --method all -o x.txt", "name one method"},
      {"order path.graph --cells -o x.txt", "it has no cells"},
      {"order path.graph -o x.su2", ".su2"},
      {"order square.su2 --cells -o x.su2", "renumbered by its vertices"},
      {"order path.graph --picture x.bmp", ".bmp"},
      {"order beam.mesh -o x.poly", ".poly"},
      {"order cut.mesh -o x.txt", "cut.mesh:4"},
  };
  for (const auto& line : table) {
    const std::string &arguments = line.first, &words = line.second;
    const auto ran = run(arguments, scratch.path());
    CAPTURE(arguments);
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 2);
    CHECK(ran.err.find(words) != std::string::npos);
    for (const char* output : {"x.txt", "x.su2", "x.bmp"})
      CHECK_FALSE(std::filesystem::exists(scratch.path() / output));
  }
  CHECK(run("order path.graph --method bogus", scratch.path()).exit_code == 1);
}
