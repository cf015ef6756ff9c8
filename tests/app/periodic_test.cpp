// SPDX-License-Identifier: MIT
// Periodic sides through the program.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/app/program.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;
using nlohmann::json;

namespace {

/// A row of wavy floors, one period of it: 16 x 6 quadrilaterals, 2 long, the floor a cosine.
/// lift  of the middle of the outlet side
std::string floors(double lift) {
  constexpr int nx = 16, ny = 6;
  std::ostringstream text;
  text << "NDIME= 2\nNELEM= " << nx * ny << "\n";
  const auto id = [](int i, int j) { return i + (nx + 1) * j; };
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      text << "9 " << id(i, j) << ' ' << id(i + 1, j) << ' ' << id(i + 1, j + 1) << ' ' << id(i, j + 1) << '\n';
  text << "NPOIN= " << (nx + 1) * (ny + 1) << '\n';
  text.precision(17);
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double x = 2.0 * i / nx, floor = 0.05 * (1 - std::cos(3.141592653589793 * x));
      text << x << ' ' << floor + (1 - floor) * j / ny + (i == nx && j == ny / 2 ? lift : 0) << '\n';
    }
  const auto side = [&](const char* name, int count, const auto& from, const auto& to) {
    text << "MARKER_TAG= " << name << "\nMARKER_ELEMS= " << count << '\n';
    for (int k = 0; k < count; ++k) text << "3 " << from(k) << ' ' << to(k) << '\n';
  };
  text << "NMARK= 4\n";
  side("floor", nx, [&](int k) { return id(k, 0); }, [&](int k) { return id(k + 1, 0); });
  side("out", ny, [&](int k) { return id(nx, k); }, [&](int k) { return id(nx, k + 1); });
  side("top", nx, [&](int k) { return id(k + 1, ny); }, [&](int k) { return id(k, ny); });
  side("in", ny, [&](int k) { return id(0, k + 1); }, [&](int k) { return id(0, k); });
  return text.str();
}

const std::string floors_case =
    "mesh = \"floors.su2\"\n[flow]\nmach = 0.4\n[boundary.floor]\nkind = \"slip-wall\"\n[boundary.top]\nkind = \"far-field\"\n"
    "[boundary.in]\nkind = \"periodic\"\npartner = \"out\"\n[boundary.out]\nkind = \"periodic\"\npartner = \"in\"\n";

}  // namespace

TEST_CASE("a_row_of_wavy_floors_is_solved_on_one_period_with_equal_states_on_both_sides") {
  const ScratchFolder scratch;
  scratch.write("floors.su2", floors(0));
  scratch.write("case.toml", floors_case + "translation = [-2, 0]\n");
  const auto ran = run("solve case.toml -o out --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["outcome"] == "converged");
  CHECK(std::abs(report["cd"].get<double>()) < 2e-3);
  // A start from the run's own field is there at once.
  scratch.write("again.toml", floors_case + "[initial]\nfield = \"out/field.vtu\"\n[solver]\nresidual_drop_orders = 1\nmax_iterations = 3\n");
  const json again = json::parse(run("solve again.toml -o again --json", scratch.path()).out);
  CHECK(again["cl"].get<double>() == doctest::Approx(report["cl"].get<double>()).epsilon(1e-6));
}

TEST_CASE("periodic_sides_that_do_not_match_or_contradict_each_other_are_refused_before_the_march") {
  const ScratchFolder scratch;
  scratch.write("floors.su2", floors(1e-3));
  const auto refusal = [&](const std::string& text) {
    scratch.write("case.toml", text);
    const auto ran = run("solve case.toml -o out", scratch.path());
    CHECK(ran.exit_code == 2);
    CHECK_FALSE(std::filesystem::exists(scratch.path() / "out"));
    return ran.err;
  };
  const std::string bent = refusal(floors_case);
  CAPTURE(bent);
  CHECK(bent.find("1 of \"in\" have no partner: 51 at (0, 0.5") != std::string::npos);
  CHECK(bent.find("1 of \"out\" have no partner: 67 at (2, 0.501") != std::string::npos);
  CHECK(refusal(floors_case + "translation = [-2, 0, 0]\n").find("give 2 numbers") != std::string::npos);
  std::string alone = floors_case;
  alone.replace(alone.find("partner = \"in\""), 14, "partner = \"top\"");
  CHECK(refusal(alone).find("case.toml:8: boundary.in has boundary.out as its partner, but not the other way round") != std::string::npos);
  alone.replace(alone.find("partner = \"out\""), 15, "");
  CHECK(refusal(alone).find("boundary.in is periodic but names no partner") != std::string::npos);
}
