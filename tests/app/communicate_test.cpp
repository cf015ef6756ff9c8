// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

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

/// A path of eight vertices, and a ring of six with a vertex in its middle.
const std::string path_graph = "8 7\n2\n1 3\n2 4\n3 5\n4 6\n5 7\n6 8\n7\n";
const std::string wheel_graph = "7 12\n2 6 7\n1 3 7\n2 4 7\n3 5 7\n4 6 7\n1 5 7\n1 2 3 4 5 6\n";

json report_of(const ScratchFolder& scratch, const std::string& arguments) {
  const Ran ran = run("communicate " + arguments + " --quiet --json", scratch.path());
  CAPTURE(arguments);
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  return json::parse(ran.out);
}

}  // namespace

TEST_CASE("communicate_tells_what_the_parts_of_a_path_send_and_what_that_costs") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph);
  scratch.write("parts.txt", "0\n0\n1\n1\n2\n2\n3\n3\n");
  const json report = report_of(scratch, "path.graph --parts-file parts.txt --alpha 1 --beta 2");
  CHECK(report["parts"] == 4);
  CHECK(report["cut"] == 3);
  CHECK(report["halo"] == json({1, 2, 2, 1}));
  const json& communication = report["communication"];
  CHECK(communication["exchanges"] == 3);
  CHECK(communication["cycle_count"] == 2);
  CHECK(communication["fewest_cycles"] == true);
  CHECK(communication["values_sent"] == json({1, 2, 2, 1}));
  CHECK(communication["synchronous_seconds"] == 6);   // two cycles of 1 + 2
  CHECK(communication["busiest_part_seconds"] == 6);  // two exchanges
  CHECK(communication["all_messages_seconds"] == 9);
}

TEST_CASE("communicate_makes_a_schedule_in_which_no_part_is_asked_twice_at_a_time") {
  const ScratchFolder scratch;
  scratch.write("beam.mesh", beam(6));
  const double alpha = 3e-6, beta = 2e-8;
  const json report =
      report_of(scratch, "beam.mesh -k 7 --of vertices --alpha 3e-6 --beta 2e-8 --picture c.png");
  CHECK(std::filesystem::file_size(scratch.path() / "c.png") > 1000);
  double seconds = 0;
  std::size_t exchanges = 0, values = 0;
  for (const json& cycle : report["communication"]["cycles"]) {
    std::set<int> busy;
    std::size_t longest = 0;
    for (const json& exchange : cycle) {
      CHECK(busy.insert(exchange["first"].get<int>()).second);
      CHECK(busy.insert(exchange["second"].get<int>()).second);
      const std::size_t there = exchange["forwards"], back = exchange["backwards"];
      longest = std::max({longest, there, back});
      values += there + back;
      ++exchanges;
    }
    seconds += alpha + beta * static_cast<double>(longest);
  }
  CHECK(exchanges == report["communication"]["exchanges"]);
  CHECK(values == report["communication"]["values"]);
  CHECK(report["total_halo"] <= values);
  CHECK(report["communication"]["synchronous_seconds"].get<double>() == doctest::Approx(seconds));
}

TEST_CASE("communicate_reckons_with_other_numbers_of_parts") {
  const ScratchFolder scratch;
  scratch.write("beam.mesh", beam(8));
  const json report =
      report_of(scratch, "beam.mesh -k 2 --what-if 1,4,48 --work 1e-6 --alpha 1e-6 --beta 1e-8");
  REQUIRE(report["what_if"].size() == 3);
  const json &one = report["what_if"][0], &four = report["what_if"][1], &all = report["what_if"][2];
  CHECK(one["cycles"] == 0);
  CHECK(one["speedup"].get<double>() == doctest::Approx(1));
  CHECK(all["largest"] == 1);
  CHECK(all["cut"] == report["edges"]);
  const json alone = report_of(scratch, "beam.mesh -k 4 --alpha 1e-6 --beta 1e-8");
  for (const char* same : {"cut", "imbalance", "largest", "max_neighbours", "max_halo", "total_halo"})
    CHECK(four[same] == alone[same]);
  CHECK(four["synchronous_seconds"] == alone["communication"]["synchronous_seconds"]);
  const double step = four["largest"].get<double>() * 1e-6 + four["synchronous_seconds"].get<double>();
  CHECK(four["step_seconds"].get<double>() == doctest::Approx(step));
  CHECK(four["efficiency"].get<double>() == doctest::Approx(48e-6 / (4 * step)));
  const Ran table = run("communicate beam.mesh --what-if 4,48 --quiet", scratch.path());
  CHECK(table.out.find("cycle 1") != std::string::npos);
  CHECK(table.out.find("       48") != std::string::npos);
}

TEST_CASE("communicate_colours_vertices_and_edges_for_threaded_loops") {
  const ScratchFolder scratch;
  scratch.write("wheel.graph", wheel_graph);
  const json loops =
      report_of(scratch, "wheel.graph -k 2 --vertex-colours v.txt --edge-colours e.txt -o r.json")["loops"];
  CHECK(loops["max_degree"] == 6);
  CHECK(loops["vertex_colours"] == 3);
  CHECK(loops["edge_colours"] == 6);
  CHECK(loops["edge_colours_are_fewest"] == true);
  CHECK(json::parse(text_of(scratch.path() / "r.json"))["loops"] == loops);
  const std::vector<int> of_vertex = numbers_of(scratch.path() / "v.txt"),
                         of_edge = numbers_of(scratch.path() / "e.txt");
  REQUIRE(of_vertex.size() == 7);
  REQUIRE(of_edge.size() == 3 * 12);
  std::set<std::pair<int, int>> seen;
  for (std::size_t i = 0; i < of_edge.size(); i += 3) {
    const int a = of_edge[i], b = of_edge[i + 1], colour = of_edge[i + 2];
    CHECK(a < b);
    CHECK(of_vertex[static_cast<std::size_t>(a)] != of_vertex[static_cast<std::size_t>(b)]);
    CHECK(seen.emplace(a, colour).second);
    CHECK(seen.emplace(b, colour).second);
  }
}

TEST_CASE("communicate_draws_graphs_with_and_without_coordinates") {
  const ScratchFolder scratch;
  scratch.write("wheel.graph", wheel_graph);
  scratch.write("path.graph", path_graph);
  scratch.write("path.xyz", "0 0\n1 0\n2 0\n3 0\n4 1\n5 1\n6 1\n7 1\n");
  for (const char* arguments : {"wheel.graph -k 3 --picture a.svg", "path.graph -k 4 --picture b.pdf"}) {
    const Ran ran = run(std::string("communicate --quiet ") + arguments, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
  }
  for (const char* picture : {"a.svg", "b.pdf"})
    CHECK(std::filesystem::file_size(scratch.path() / picture) > 1000);
}

TEST_CASE("communicate_has_nothing_to_tell_of_graphs_without_edges") {
  const ScratchFolder scratch;
  scratch.write("none.graph", "0 0\n");
  scratch.write("three.graph", "3 0\n\n\n\n");
  CHECK(report_of(scratch, "three.graph -k 3 --what-if 1,2")["communication"]["cycle_count"] == 0);
  for (const char* arguments :
       {"none.graph -k 1", "three.graph -k 3 --work 1 --what-if 1,2 --picture p.png"}) {
    const Ran ran = run(std::string("communicate --quiet ") + arguments, scratch.path());
    CAPTURE(ran.err);
    CHECK(ran.exit_code == 0);
    CHECK(ran.out.find("nan") == std::string::npos);
  }
}

TEST_CASE("communicate_refuses_bad_input_and_writes_nothing") {
  const ScratchFolder scratch;
  scratch.write("path.graph", path_graph);
  scratch.write("short.txt", "0\n1\n");
  scratch.write("long.txt", "0\n0\n0\n0\n0\n0\n0\n0\n1\n");
  scratch.write("word.txt", "0\n0\nx\n");
  scratch.write("two.txt", "0 1\n");
  scratch.write("less.txt", "0\n-1\n");
  scratch.write("much.txt", "0\n8\n");
  const auto refused = [&](const std::string& arguments, int exit_code, const std::string& why) {
    const Ran ran = run("communicate path.graph -o r.json --picture p.png --edge-colours e.txt " + arguments,
                        scratch.path());
    CAPTURE(arguments);
    CAPTURE(ran.err);
    CHECK(ran.exit_code == exit_code);
    CHECK(ran.err.find(why) != std::string::npos);
    for (const char* output : {"r.json", "p.png", "e.txt"})
      CHECK_FALSE(std::filesystem::exists(scratch.path() / output));
  };
  refused("--parts-file short.txt", 2, "short.txt:2: 2 parts for 8 vertices");
  refused("--parts-file long.txt", 2, "long.txt:9: more than 8 parts");
  refused("--parts-file word.txt", 2, "word.txt:3");
  refused("--parts-file two.txt", 2, "two.txt:1");
  refused("--parts-file less.txt", 2, "less.txt:2: part -1");
  refused("--parts-file much.txt", 2, "much.txt:2: part 8 of 8 vertices");
  refused("--parts-file nowhere.txt", 2, "nowhere.txt");
  refused("-k 9", 2, "9 parts of 8 vertices");
  refused("--what-if 4,9", 2, "9 parts of 8 vertices");
  refused("--what-if 0", 2, "0 parts of 8 vertices");
  refused("--what-if few", 1, "what-if");
  refused("--alpha -1", 2, "--alpha: -1 seconds");
  refused("--beta nan", 2, "--beta: nan seconds");
  refused("--work inf", 2, "--work: inf seconds");
  refused("-k 2 --parts-file short.txt", 1, "--parts");
  refused("--vertex-colours v.csv", 2, ".csv");
}
