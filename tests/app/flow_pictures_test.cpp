// SPDX-License-Identifier: MIT
// Pictures of flows and what they are drawn from; explicit marches with smoothed steps.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "leonhard/app/report/stream_function.hpp"
#include "tests/app/program.hpp"
#include "tests/solver/meshes.hpp"
#include "tests/test_files.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;
using nlohmann::json;

namespace {

const std::string airfoil =
    "[flow]\nmach = 0.5\nalpha_deg = 1\n[[body]]\nnaca = \"0012\"\nspacing = 0.03\n[mesher]\ngrowth = 0.2\n[farfield]\ndistance = 10\n"
    "[solver]\n";

/// Orders that the residual fell by in a run of the bump in space or the airfoil.
double drop_of(const ScratchFolder& scratch, const std::string& text, const std::string& solver) {
  scratch.write("case.toml", text + "marching = \"explicit\"\n" + solver);
  return json::parse(run("solve case.toml -o out --json", scratch.path()).out)["residual_drop_orders"];
}

}  // namespace

TEST_CASE("the_stream_function_of_a_stream_and_of_a_vortex_is_exact") {
  const leonhard::TriangleMesh mesh = leonhard::test::shaken_square(12, 0.25, 3);
  const leonhard::EdgeStructure edges = leonhard::mesh::build_edges(mesh);
  const leonhard::VertexId zero = leonhard::VertexId::from(20);
  const leonhard::Point2 from = mesh.points[zero];
  leonhard::PerId<leonhard::VertexId, leonhard::State<2>> stream, vortex;
  for (const leonhard::Point2 p : mesh.points) {
    stream.push_back({2, 0.3, -0.1, 1});
    vortex.push_back({1, -(p.y - 0.5), p.x - 0.5, 1});
  }
  const auto of_stream = leonhard::app::stream_function(mesh, edges, stream, zero),
             of_vortex = leonhard::app::stream_function(mesh, edges, vortex, zero);
  const auto square = [](leonhard::Point2 p) { return (p.x - 0.5) * (p.x - 0.5) + (p.y - 0.5) * (p.y - 0.5); };
  for (const leonhard::VertexId v : mesh.points.ids()) {
    const leonhard::Point2 p = mesh.points[v];
    CHECK(std::abs(of_stream[v.index()] - (0.6 * (p.y - from.y) + 0.2 * (p.x - from.x))) < 1e-10);
    CHECK(std::abs(of_vortex[v.index()] + 0.5 * (square(p) - square(from))) < 1e-10);
  }
}

TEST_CASE("the_density_of_a_plane_has_its_slope_everywhere") {
  const leonhard::TriangleMesh mesh = leonhard::test::shaken_square(8, 0.25, 3);
  leonhard::PerId<leonhard::VertexId, leonhard::State<2>> states;
  for (const leonhard::Point2 p : mesh.points) states.push_back({1 + 3 * p.x - 4 * p.y, 0, 0, 1});
  for (const double slope : leonhard::app::density_slopes(mesh, states)) CHECK(slope == doctest::Approx(5));
}

TEST_CASE("a_run_draws_streamlines_schlieren_and_entropy_and_one_that_hangs_its_worst_vertices") {
  const ScratchFolder scratch;
  scratch.write("case.toml", airfoil + "max_iterations = 3\n");
  const auto ran = run("solve case.toml -o out --json", scratch.path());
  CHECK(ran.exit_code == 3);
  const json report = json::parse(ran.out);
  CHECK(report["worst_vertices"].size() == 10);
  CHECK(report["residual_at_rounding"] == false);
  for (const char* name : {"streamlines.png", "schlieren.png", "entropy.png", "worst.png"})
    CHECK_MESSAGE(std::filesystem::exists(scratch.path() / "out" / name), name);
  scratch.write("case.toml", airfoil);
  const json done = json::parse(run("solve case.toml -o done --json", scratch.path()).out);
  CHECK_FALSE(done.contains("worst_vertices"));
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "done/worst.png"));
  double sum = 0;
  REQUIRE(done["boundaries"].size() == 2);
  for (const json& boundary : done["boundaries"]) sum += boundary["mass_flow_out"].get<double>();
  CHECK(std::abs(sum) < 1e-6);
}

TEST_CASE("smoothed_explicit_steps_bear_a_cfl_number_that_plain_ones_do_not_and_get_further") {
  const ScratchFolder scratch;
  const std::string coarse =
      "[flow]\nmach = 0.5\nalpha_deg = 1\n[[body]]\nnaca = \"0012\"\nspacing = 0.06\n[mesher]\ngrowth = 0.3\n[farfield]\ndistance = 6\n"
      "[solver]\n";
  const std::string limit = "max_iterations = 300\n";
  const double slow = drop_of(scratch, coarse, limit + "cfl_start = 4\n"),
               plain = drop_of(scratch, coarse, limit + "cfl_start = 7\n"),
               smoothed = drop_of(scratch, coarse, limit + "cfl_start = 7\nresidual_smoothing = 0.15\n");
  MESSAGE(slow << ' ' << plain << ' ' << smoothed);
  CHECK(smoothed > slow + 0.5);
  CHECK(smoothed > plain + 0.5);

  const std::filesystem::path bump = leonhard::test::source_folder() / "examples/bump3d";
  std::filesystem::copy_file(bump / "bump.su2", scratch.path() / "bump.su2");
  const std::string space = leonhard::test::text_of(bump / "bump.toml") + "\n[solver]\nlimiter = \"none\"\n", few = "max_iterations = 60\n";
  const double plain_space = drop_of(scratch, space, few + "cfl_start = 4\n"),
               smoothed_space = drop_of(scratch, space, few + "cfl_start = 8\nresidual_smoothing = 0.15\n");
  MESSAGE(plain_space << ' ' << smoothed_space);
  CHECK(smoothed_space > plain_space + 0.1);
}
