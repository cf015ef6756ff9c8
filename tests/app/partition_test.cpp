// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "leonhard/mesh/io/tet_mesh_file.hpp"
#include "leonhard/mesh/io/vtu.hpp"
#include "tests/app/beam.hpp"
#include "tests/app/program.hpp"

using leonhard::test::beam;
using leonhard::test::numbers_of;
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
  const std::vector<int> parts = numbers_of(scratch.path() / "parts.txt");
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

TEST_CASE("partition_of_a_beam_of_tetrahedra_cuts_it_between_two_cubes") {
  const ScratchFolder scratch;
  scratch.write("beam.mesh", beam(8));
  const Ran ran = run("partition beam.mesh -k 2 --imbalance 0 -o parts.vtu --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["vertices"] == 48);
  CHECK(report["cut"] == 2);  // a square between two cubes is two triangles
  CHECK(report["sizes"] == json({24, 24}));
  const auto file = leonhard::io::read_tet_mesh(scratch.path() / "parts.vtu");
  const auto& mesh = file.mesh;
  REQUIRE(file.cell_fields.size() == 1);
  CHECK(file.cell_fields[0].name == "part");
  const auto& parts = file.cell_fields[0].values;
  REQUIRE(mesh.tet_count() == 48);
  for (const leonhard::TetId t : mesh.corners.ids()) {
    double x = 0;
    for (const leonhard::VertexId v : mesh.corners[t]) x += mesh.points[v].x / 4;
    CHECK((x < 4) == (parts[t.index()] == parts[0]));
  }
}

TEST_CASE("partition_says_what_it_shares_out") {
  const ScratchFolder scratch;
  scratch.write("beam.mesh", beam(2));
  const Ran cells = run("partition beam.mesh -k 2", scratch.path());
  CHECK(cells.out.find("12 vertices (the tetrahedra), ") != std::string::npos);
  CHECK(cells.out.find("6 to 6 tetrahedra, ") != std::string::npos);
  const Ran vertices = run("partition beam.mesh -k 2 --of vertices", scratch.path());
  CHECK(vertices.out.find("12 vertices, ") != std::string::npos);
  CHECK(vertices.out.find("6 to 6 vertices, ") != std::string::npos);
  CHECK(json::parse(run("partition beam.mesh -k 2 --json", scratch.path()).out)["of"] == "tetrahedra");
  CHECK(run("communicate beam.mesh -k 2", scratch.path()).out.find("tetrahedra in ") != std::string::npos);
}

TEST_CASE("partition_of_the_vertices_of_a_beam_names_the_part_of_each_point") {
  const ScratchFolder scratch;
  scratch.write("beam.mesh", beam(7));
  const Ran ran =
      run("partition beam.mesh -k 2 --method inertial --of vertices -o parts.vtu --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  CHECK(json::parse(ran.out)["vertices"] == 32);
  const auto mesh = leonhard::io::read_tet_mesh(scratch.path() / "parts.vtu").mesh;
  const auto parts = leonhard::io::read_vtu_field(scratch.path() / "parts.vtu", "part").values;
  REQUIRE(parts.size() == 32);
  for (const leonhard::VertexId v : mesh.points.ids())
    CHECK((mesh.points[v].x < 3.5) == (parts[v.index()] == parts.front()));
}

TEST_CASE("partition_draws_the_parts_of_meshes_and_of_graphs_with_coordinates") {
  const ScratchFolder scratch;
  scratch.write("beam.mesh", beam(8));
  scratch.write("path.graph", path_graph(6));
  scratch.write("path.xyz", "0 0\n1 0\n2 0\n3 1\n4 0\n5 0\n");
  scratch.write("bent.graph", path_graph(4));
  scratch.write("bent.xyz", "0 0 0\n1 0 0\n1 1 0\n1 1 1\n");
  for (const char* arguments :
       {"beam.mesh -k 4 -o cells.png --view 30,20 --cut none", "beam.mesh -k 4 --of vertices -o vertices.svg",
        "path.graph -k 2 -o path.svg --view 0,0,3,1", "path.graph -k 6 -o path.pdf",
        "bent.graph -k 2 -o bent.png --view 10,80"}) {
    const Ran ran = run(std::string("partition --quiet ") + arguments, scratch.path());
    CAPTURE(arguments);
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
  }
  for (const char* picture : {"cells.png", "vertices.svg", "path.svg", "path.pdf", "bent.png"})
    CHECK(std::filesystem::file_size(scratch.path() / picture) > 1000);
}

TEST_CASE("partition_draws_the_edges_of_a_graph_and_the_cut_ones_dark") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph(6));
  scratch.write("path.xyz", "0 0\n1 0\n2 0\n3 1\n4 0\n5 0\n");
  const auto strokes = [&](int parts, bool dark) {
    CHECK(run("partition path.graph --quiet -o path.svg -k " + std::to_string(parts), scratch.path())
              .exit_code == 0);
    std::string svg = text_of(scratch.path() / "path.svg");
    std::erase_if(svg, [](char c) { return c == ' ' || c == '"'; });
    std::size_t all = 0, of_cut = 0;
    for (const char* stroke : {"stroke:rgb(", "stroke=rgb("})  // as old and new versions of cairo write
      for (std::size_t at = svg.find(stroke); at != std::string::npos; at = svg.find(stroke, at + 1)) {
        ++all;
        if (svg.compare(at + 7, 14, "rgb(8%,8%,10%)") == 0) ++of_cut;
      }
    return dark ? of_cut : all - of_cut;
  };
  CHECK(strokes(2, true) == 1);
  CHECK(strokes(2, false) == 4);
  CHECK(strokes(6, true) == 5);
  CHECK(strokes(6, false) == 0);
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
  refused("path.graph -k 2 -o parts.png", 2, "no coordinates to draw them at; put them into path.xyz");
  refused("path.graph -k 2 -o parts.vtu", 2, "has no cells");
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "parts.png"));
  scratch.write("two.graph", "2 1 10 2\n1 1 2\n1 1 1\n");
  const Ran two_weights = run("partition two.graph -k 2", scratch.path());
  CHECK(two_weights.exit_code == 0);
  CHECK(two_weights.err.find("the first one is used") != std::string::npos);
  scratch.write("flat.mesh",
                "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                "1 1 0 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n");
  refused("flat.mesh -k 2", 2, "flat.mesh:11");
  scratch.write("beam.mesh", beam(1));
  refused("beam.mesh -k 2 -o parts.png --view 0,0,1,1", 2, "--view: 4 numbers");
  refused("beam.mesh -k 2 -o parts.png --cut w", 2, "--cut: 'w' is no plane");
  scratch.write("flat.graph", path_graph(2));
  scratch.write("flat.xyz", "0 0\n1 1\n");
  refused("flat.graph -k 2 -o parts.png --view 1,2", 2, "--view: 2 numbers");
  refused("flat.graph -k 2 -o parts.png --cut x", 2, "--cut");
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "parts.png"));
  refused("path.graph -k 2 -o parts.txt --view 0,0,1,1", 2, "--view: parts.txt is no picture");
  refused("beam.mesh -k 2 -o parts.vtu --cut x", 2, "--cut: parts.vtu is no picture");
  refused("path.graph -k 2 --of tetrahedra", 1, "tetrahedra");
  refused("path.graph -k 2 -o parts.docx", 2, ".txt");
  refused("path.graph -k 2 --method inertial", 2, "points for 5 vertices");
  refused("missing.graph -k 2", 2, "missing.graph");
  refused("path.graph -k 0", 1, "--parts");
  refused("path.graph -k 2 --method magic", 1, "magic");
}
