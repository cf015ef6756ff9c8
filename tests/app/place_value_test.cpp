// SPDX-License-Identifier: MIT
// Boundaries and starts whose values vary with the place, through the program.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "tests/app/program.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;
using nlohmann::json;

namespace {

/// A square of unit sides: 1 and 3 are walls, 4 lets in, 2 out.
const std::string square = "4 2 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 3\n4 0 1 3\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n";

std::string shear_case(const std::string& inflow, const std::string& more = "") {
  return "domain = \"square.poly\"\n[flow]\nmach = 2\n[mesher]\nsize = 0.08\n[boundary.1]\nkind = \"slip-wall\"\n"
         "[boundary.3]\nkind = \"slip-wall\"\n[boundary.2]\nkind = \"supersonic-outflow\"\n[boundary.4]\n"
         "kind = \"supersonic-inflow\"\n" +
         inflow + more;
}

/// Greatest difference of a run's first velocity component from 2 (1 + 0.15 y).
double error_of(const std::filesystem::path& field) {
  const auto file = leonhard::io::read_mixed_mesh<2>(field);
  double worst = 0;
  for (const auto& values : file.point_fields)
    if (values.name == "velocity")
      for (const leonhard::VertexId v : file.mesh.points.ids())
        worst = std::max(worst, std::abs(values.values[2 * v.index()] - 2 * (1 + 0.15 * file.mesh.points[v].y)));
  return worst;
}

}  // namespace

TEST_CASE("a_shear_flow_given_by_a_formula_or_a_table_crosses_a_square_unchanged_and_a_start_from_it_is_there") {
  const ScratchFolder scratch;
  scratch.write("square.poly", square);
  const std::string formula = "velocity = [\"1 + 0.15*y\", 0]\n";
  scratch.write("formula.toml", shear_case(formula));
  const auto ran = run("solve formula.toml -o formula --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  CHECK(error_of(scratch.path() / "formula/field.vtu") < 2e-3);
  scratch.write("table.toml", shear_case("velocity = [{ along = \"y\", at = [0, 1], values = [1, 1.15] }, 0]\n"));
  REQUIRE(run("solve table.toml -o table --json", scratch.path()).exit_code == 0);
  CHECK(error_of(scratch.path() / "table/field.vtu") == doctest::Approx(error_of(scratch.path() / "formula/field.vtu")).epsilon(1e-4));

  scratch.write("start.toml", shear_case(formula, "[initial]\n" + formula + "[solver]\nmax_iterations = 1\n"));
  (void)run("solve start.toml -o start", scratch.path());
  CHECK(error_of(scratch.path() / "start/field.vtu") < 3e-2);
  scratch.write("cold.toml", shear_case(formula, "[solver]\nmax_iterations = 1\n"));
  (void)run("solve cold.toml -o cold", scratch.path());
  CHECK(error_of(scratch.path() / "cold/field.vtu") > 5e-2);
}

TEST_CASE("a_value_that_is_out_of_range_somewhere_on_the_boundary_is_refused_with_the_place") {
  const ScratchFolder scratch;
  scratch.write("square.poly", square);
  scratch.write("case.toml", shear_case("pressure = \"0.5 - y\"\n"));
  const auto ran = run("solve case.toml -o out", scratch.path());
  CHECK(ran.exit_code == 2);
  CHECK_MESSAGE(ran.err.find("case.toml:14: boundary.4.pressure is ") != std::string::npos, ran.err);
  CHECK(ran.err.find("it takes a finite number above 0 at every place") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "out"));
}
