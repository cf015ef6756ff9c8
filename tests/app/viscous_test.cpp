// SPDX-License-Identifier: MIT
// Viscous cases in the plane, and starts from another run's field.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;
using leonhard::test::text_of;
using nlohmann::json;

namespace {

const std::string laminar =
    "[flow]\nmach = 0.5\nreynolds = 5000\n[[body]]\nname = \"airfoil\"\nnaca = \"0012\"\nspacing = 0.012\n"
    "leading_edge_spacing = 0.005\ntrailing_edge_spacing = 0.006\n[farfield]\ndistance = 15\n[mesher]\ngrowth = 0.2\n"
    "[solver]\nlimiter = \"none\"\n[partition]\nparts = 3\n";

/// A square of unit sides, each with a marker.
const std::string square =
    "4 2 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 3\n4 0 1 3\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n";

}  // namespace

TEST_CASE("a_laminar_airfoil_reports_friction_apart_heights_of_cells_and_separation_on_both_sides") {
  const ScratchFolder scratch;
  scratch.write("case.toml", laminar);
  const auto ran = run("solve case.toml -o out --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["outcome"] == "converged");
  const double cd = report["cd"], pressure = report["cd_pressure"], friction = report["cd_friction"];
  CHECK(pressure + friction == doctest::Approx(cd).epsilon(1e-12));
  CHECK(cd == doctest::Approx(0.0556).epsilon(0.15));  // coarse
  CHECK(friction > pressure);
  CHECK(report["bodies"][0]["cd_friction"] == report["cd_friction"]);
  CHECK(report["flow"]["reynolds"] == 5000);
  CHECK(report["walls"]["y_plus_min"] > 0);
  CHECK(report["walls"]["y_plus_max"] < 20);
  bool above = false, below = false, nose = false;
  for (const json& zero : report["walls"]["friction_zeros"]) {
    const double x = zero["x"], y = zero["y"];
    if (zero["kind"] == "separation" && x > 0.6 && x < 0.97) (y > 0 ? above : below) = true;
    if (zero["kind"] == "attachment" && x < 0.01) nose = true;
  }
  CHECK(above);
  CHECK(below);
  CHECK(nose);

  std::istringstream csv(text_of(scratch.path() / "out/surface.csv"));
  std::string line;
  std::getline(csv, line);
  CHECK(line == "body,x,y,s,cp,mach,cf,heat,y_plus");
  double largest = 0;
  while (std::getline(csv, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i < 7; ++i) std::getline(cells, cell, ',');
    largest = std::max(largest, std::stod(cell));
  }
  CHECK(largest > 0.08);
  for (const char* name : {"cf.png", "vorticity.png", "total-pressure-loss.png"})
    CHECK_MESSAGE(std::filesystem::exists(scratch.path() / "out" / name), name);
  const std::string page = text_of(scratch.path() / "out/report.html");
  CHECK(page.find("Re = 5000") != std::string::npos);
  CHECK(page.find("of friction") != std::string::npos);
  CHECK(page.find("<td>separation</td>") != std::string::npos);

  // Started from its own field it is there, and from that of another mesh it does not start.
  scratch.write("again.toml", laminar + "[initial]\nfield = \"out/field.vtu\"\n[order]\nmethod = \"none\"\n");
  const auto again = run("solve again.toml -o again --json", scratch.path());
  CAPTURE(again.err);
  const json second = json::parse(again.out);
  CHECK(second["cd"].get<double>() == doctest::Approx(cd).epsilon(1e-6));
  std::istringstream history(text_of(scratch.path() / "again/history.csv"));
  std::getline(history, line), std::getline(history, line);
  CHECK(std::stod(line.substr(line.find(',', line.find(',', 2) + 1) + 1)) == doctest::Approx(cd).epsilon(1e-6));

  std::string other = laminar;
  other.replace(other.find("growth = 0.2"), 12, "growth = 0.3");
  scratch.write("other.toml", other + "[initial]\nfield = \"out/field.vtu\"\n");
  const auto refused = run("solve other.toml -o other", scratch.path());
  CHECK(refused.exit_code == 2);
  CHECK(refused.err.find("field.vtu: has") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "other"));
}

TEST_CASE("a_lid_drives_a_cavity_and_what_the_lid_does_is_in_the_case") {
  const ScratchFolder scratch;
  scratch.write("square.poly", square);
  const std::string head =
      "domain = \"square.poly\"\n[flow]\nmach = 0.1\nreynolds = 100\nviscosity = \"constant\"\n[mesher]\nsize = 0.06\n"
      "[partition]\nparts = 2\n";
  const auto walls = [](const std::string& lid) {
    std::string text;
    for (const char* name : {"1", "2", "4"})
      text += std::string("[boundary.") + name + "]\nkind = \"no-slip-wall\"\ntemperature = 1\n";
    return text + "[boundary.3]\nname = \"lid\"\nkind = \"no-slip-wall\"\ntemperature = 1\n" + lid;
  };
  scratch.write("lid.toml", head + walls("velocity = [1, 0]\n"));
  const auto ran = run("solve lid.toml -o lid --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  double drag = 0;
  const json report = json::parse(ran.out);
  for (const json& body : report["bodies"])
    if (body["name"] == "lid") drag = body["cd_friction"];
  CHECK(drag < -0.05);  // the gas holds the lid back
  scratch.write("still.toml", head + walls(""));
  const auto still = json::parse(run("solve still.toml -o still --json", scratch.path()).out);
  for (const json& body : still["bodies"]) CHECK(std::abs(body["cd_friction"].get<double>()) < std::abs(drag) / 1000);
}

TEST_CASE("a_duct_between_a_total_pressure_and_a_pressure_runs_at_the_speed_of_the_ratio") {
  const ScratchFolder scratch;
  scratch.write("square.poly", square);
  // Mach 0.3 from p0 to p: p / p0 = (1 + 0.2 M^2)^-3.5, with p0 that of a free stream of Mach 0.5.
  const double total = std::pow(1 + 0.2 * 0.25, 3.5), pressure = total / std::pow(1 + 0.2 * 0.09, 3.5);
  std::ostringstream text;
  text << "domain = \"square.poly\"\n[flow]\nmach = 0.5\n[mesher]\nsize = 0.1\n[partition]\nparts = 2\n"
       << "[boundary.1]\nkind = \"slip-wall\"\n[boundary.3]\nkind = \"slip-wall\"\n"
       << "[boundary.4]\nkind = \"subsonic-inflow\"\n[boundary.2]\nkind = \"pressure-outflow\"\npressure = " << pressure << "\n";
  scratch.write("duct.toml", text.str());
  const auto ran = run("solve duct.toml -o out", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  std::istringstream csv(text_of(scratch.path() / "out/surface.csv"));
  std::string line;
  std::getline(csv, line);
  CHECK(line == "body,x,y,s,cp,mach");
  int count = 0;
  while (std::getline(csv, line)) {
    CHECK(std::stod(line.substr(line.rfind(',') + 1)) == doctest::Approx(0.3).epsilon(1e-4));
    ++count;
  }
  CHECK(count > 10);
}
