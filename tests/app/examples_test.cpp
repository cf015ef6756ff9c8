// SPDX-License-Identifier: MIT
// The examples against exact and published figures, solved by the program of this build, or by that of which the environment
// says LEONHARD_EXAMPLES_PROGRAM: under sanitizers they take minutes, and the figures are what counts.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <vector>

#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/vtu.hpp"
#include "tests/app/program.hpp"
#include "tests/test_files.hpp"

using leonhard::Point2;
using leonhard::test::run;
using leonhard::test::ScratchFolder;
using leonhard::test::text_of;
using nlohmann::json;

namespace {

json solve(const ScratchFolder& scratch, const std::string& example) {
  const char* program = std::getenv("LEONHARD_EXAMPLES_PROGRAM");
  const auto ran =
      run("solve '" + (leonhard::test::source_folder() / "examples" / example).string() + "' -o out --json",
          scratch.path(), program == nullptr ? "" : program);
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  return json::parse(ran.out);
}

/// Where a level is crossed on the edges of a mesh.
std::vector<Point2> crossings(const leonhard::TriangleMesh& mesh, const std::vector<double>& values,
                              double level) {
  std::vector<Point2> points;
  for (const auto& [a, b] : leonhard::mesh::build_edges(mesh).ends) {
    const double va = values[a.index()] - level, vb = values[b.index()] - level;
    if (va * vb < 0) points.push_back(mesh.points[a] + va / (va - vb) * (mesh.points[b] - mesh.points[a]));
  }
  return points;
}

/// Angle of the line through the points that fits them best, degrees from the x axis.
double angle_deg(const std::vector<Point2>& points) {
  const double n = static_cast<double>(points.size());
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (const Point2 p : points) x += p.x / n, y += p.y / n;
  for (const Point2 p : points)
    xx += (p.x - x) * (p.x - x), xy += (p.x - x) * (p.y - y), yy += (p.y - y) * (p.y - y);
  return 0.5 * std::atan2(2 * xy, xx - yy) * 180 / std::numbers::pi;
}

struct SurfaceRow {
  double x, y, cp;
};

std::vector<SurfaceRow> surface(const std::filesystem::path& file) {
  std::istringstream in(text_of(file));
  std::vector<SurfaceRow> rows;
  std::string line;
  std::getline(in, line);  // the header
  while (std::getline(in, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    std::string body;
    SurfaceRow row{};
    double s = 0;
    words >> body >> row.x >> row.y >> s >> row.cp;
    rows.push_back(row);
  }
  return rows;
}

/// Middle of the steepest rise of the pressure along one side of an airfoil, away from its ends.
double shock_position(std::vector<SurfaceRow> rows, bool upper) {
  std::erase_if(rows,
                [&](const SurfaceRow& row) { return (row.y > 0) != upper || row.x < 0.2 || row.x > 0.8; });
  std::ranges::sort(rows, {}, &SurfaceRow::x);
  double steepest = 0, at = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double slope = (rows[i].cp - rows[i - 1].cp) / (rows[i].x - rows[i - 1].x);
    if (slope > steepest) steepest = slope, at = (rows[i].x + rows[i - 1].x) / 2;
  }
  return at;
}

}  // namespace

TEST_CASE("the_wedge_has_the_exact_oblique_shock") {
  const ScratchFolder scratch;
  const json report = solve(scratch, "wedge/wedge.toml");
  CHECK(report["outcome"] == "converged");
  const auto mesh = leonhard::io::read_mesh(scratch.path() / "out/field.vtu").mesh;
  const auto pressure = leonhard::io::read_vtu_field(scratch.path() / "out/field.vtu", "pressure").values;
  const double before = 1 / 1.4;
  auto shock = crossings(mesh, pressure, before * (1 + 1.706579) / 2);
  // Near the corner and the outlet the shock is not yet, or no longer, straight.
  const double corner = 0;
  std::erase_if(shock, [&](Point2 p) { return p.x < corner + 0.15 || p.x > 0.9; });
  REQUIRE(shock.size() > 50);
  const double angle = angle_deg(shock);
  CAPTURE(angle);
  CHECK(std::abs(angle - 39.31393) < 0.3);  // theta-beta-Mach relation, M 2, 10 degrees

  // Behind the shock, on the ramp, away from its ends.
  double sum = 0;
  int count = 0;
  for (const SurfaceRow& row : surface(scratch.path() / "out/surface.csv")) {
    if (row.x < corner + 0.2 || row.x > 0.9 || row.y > 0.3) continue;
    sum += row.cp;
    ++count;
  }
  REQUIRE(count > 20);
  const double ratio = 1 + sum / count * 0.5 * 1.4 * 2 * 2;
  CAPTURE(ratio);
  CHECK(std::abs(ratio / 1.706579 - 1) < 0.01);
}

TEST_CASE("the_transonic_airfoil_has_the_published_forces_and_shocks") {
  const ScratchFolder scratch;
  const json report = solve(scratch, "naca0012/transonic.toml");
  CHECK(report["outcome"] == "converged");
  CHECK(report["residual_drop_orders"] >= 8.0);
  CHECK(report["mesh"]["vertices"] >= 15000);
  CHECK(report["mesh"]["vertices"] <= 25000);
  CHECK(report["area"]["equal"] == true);
  CAPTURE(report["cl"].dump());
  CAPTURE(report["cd"].dump());
  CHECK(std::abs(report["cl"].get<double>() / 0.334 - 1) < 0.02);
  CHECK(std::abs(report["cd"].get<double>() / 0.0216 - 1) < 0.05);
  const auto rows = surface(scratch.path() / "out/surface.csv");
  const double upper = shock_position(rows, true), lower = shock_position(rows, false);
  CAPTURE(upper);
  CAPTURE(lower);
  CHECK(std::abs(upper - 0.625) < 0.01);  // 0.62 to 0.63
  CHECK(std::abs(lower - 0.345) < 0.01);  // 0.34 to 0.35
}

TEST_CASE("the_subsonic_airfoil_has_the_published_lift_and_no_drag") {
  const ScratchFolder scratch;
  const json report = solve(scratch, "naca0012/subsonic.toml");
  CHECK(report["outcome"] == "converged");
  CHECK(std::abs(report["cl"].get<double>() / 0.179 - 1) < 0.02);
  CHECK(std::abs(report["cd"].get<double>()) < 0.001);
}

TEST_CASE("the_cylinder_has_the_published_drag_and_separates_where_it_should") {
  const ScratchFolder scratch;
  const json report = solve(scratch, "cylinder/re40.toml");
  CHECK(report["outcome"] == "converged");
  CHECK(std::abs(report["cd"].get<double>() / 1.52 - 1) < 0.02);
  CHECK(std::abs(report["cl"].get<double>()) < 0.001);
  int separations = 0;
  for (const json& zero : report["walls"]["friction_zeros"]) {
    if (zero["kind"] != "separation") continue;
    const double from_rear = std::atan2(std::abs(zero["y"].get<double>()), zero["x"].get<double>()) * 180 / std::numbers::pi;
    CAPTURE(from_rear);
    CHECK(std::abs(from_rear - 53.7) < 0.7);  // 53.5 to 54
    ++separations;
  }
  CHECK(separations == 2);
}

TEST_CASE("the_bump_in_space_lifts_and_has_next_to_no_drag") {
  const ScratchFolder scratch;
  const json report = solve(scratch, "bump3d/bump.toml");
  CHECK(report["outcome"] == "converged");
  CHECK(report["mesh"]["prisms"] == 2 * report["mesh"]["hexahedra"].get<int>());
  CHECK(std::abs(report["cd"].get<double>()) < 0.004);
  for (const json& body : report["bodies"]) {
    if (body["name"] == "bump") CHECK(body["cl"] > 0.05);
    if (body["name"] == "top") CHECK(body["cl"] < -0.05);
  }
}
