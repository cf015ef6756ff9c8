// SPDX-License-Identifier: MIT
// Flows in space through the program.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <vector>

#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "tests/app/program.hpp"

using leonhard::test::run;
using leonhard::test::ScratchFolder;
using leonhard::test::text_of;
using nlohmann::json;

namespace {

/// A channel of 12 x 4 x 4 hexahedra with a bump on its floor; those of the farther half cut into prisms.
std::string channel() {
  constexpr int nx = 12, ny = 4, nz = 4;
  const auto id = [](int i, int j, int k) { return i + (nx + 1) * (j + (ny + 1) * k); };
  std::ostringstream points, cells;
  std::map<std::string, std::vector<std::string>> sides;
  std::size_t cell_count = 0;
  const auto words = [](int type, const std::vector<int>& ids) {
    std::string text = std::to_string(type);
    for (const int v : ids) text += " " + std::to_string(v);
    return text + "\n";
  };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const double x = 3.0 * i / nx, y = 1.0 * j / ny, s = std::cos(std::numbers::pi * (x - 1.5));
        const double floor = std::abs(x - 1.5) < 0.5 ? 0.08 * s * s * (1 + std::cos(std::numbers::pi * y)) / 2 : 0;
        points << x << ' ' << y << ' ' << floor + (1 - floor) * k / nz << '\n';
      }
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::array<int, 4> c{id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k)},
            d{id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)};
        const bool whole = j < ny / 2;
        if (whole)
          cells << words(12, {c[0], c[1], c[2], c[3], d[0], d[1], d[2], d[3]});
        else
          cells << words(13, {c[0], c[1], c[2], d[0], d[1], d[2]}) << words(13, {c[0], c[2], c[3], d[0], d[2], d[3]});
        cell_count += whole ? 1 : 2;
        const auto wall = [&](std::size_t a, std::size_t b) { return words(9, {c[a], c[b], d[b], d[a]}); };
        if (i == 0) sides["inlet"].push_back(wall(0, 3));
        if (i == nx - 1) sides["outlet"].push_back(wall(1, 2));
        if (j == 0) sides["near"].push_back(wall(0, 1));
        if (j == ny - 1) sides["far"].push_back(wall(2, 3));
        for (const bool top : {false, true}) {
          if (k != (top ? nz - 1 : 0)) continue;
          const auto& f = top ? d : c;
          auto& side = sides[top ? "roof" : "bump"];
          if (whole) {
            side.push_back(words(9, {f[0], f[1], f[2], f[3]}));
          } else {
            side.push_back(words(5, {f[0], f[1], f[2]}));
            side.push_back(words(5, {f[0], f[2], f[3]}));
          }
        }
      }
  std::ostringstream file;
  file << "NDIME= 3\nNELEM= " << cell_count << '\n' << cells.str();
  file << "NPOIN= " << (nx + 1) * (ny + 1) * (nz + 1) << '\n' << points.str() << "NMARK= " << sides.size() << '\n';
  for (const auto& [name, facets] : sides) {
    file << "MARKER_TAG= " << name << "\nMARKER_ELEMS= " << facets.size() << '\n';
    for (const std::string& facet : facets) file << facet;
  }
  return file.str();
}

std::string boundaries(const std::string& bump) {
  std::string text;
  for (const char* name : {"near", "far", "roof"})
    text += std::string("[boundary.") + name + "]\nkind = \"symmetry\"\n";
  for (const char* name : {"inlet", "outlet"})
    text += std::string("[boundary.") + name + "]\nkind = \"far-field\"\n";
  return text + "[boundary.bump]\n" + bump;
}

const std::string head = "mesh = \"channel.su2\"\n[flow]\nmach = 0.4\n";

}  // namespace

TEST_CASE("a_mesh_of_mixed_cells_of_space_is_solved_and_reported") {
  const ScratchFolder scratch;
  scratch.write("channel.su2", channel());
  scratch.write("case.toml", head + boundaries("kind = \"slip-wall\"\n") +
                                 "[reference]\narea = 2\nmoment_centre = [1.5, 0.5, 0]\n[output]\nstations = [0.2, 0.8, 7]\n");
  const auto ran = run("solve case.toml -o out --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["outcome"] == "converged");
  CHECK(report["mesh"]["hexahedra"] == 96);
  CHECK(report["mesh"]["prisms"] == 192);
  CHECK(report["mesh"]["volume"]["equal"] == true);
  CHECK(report["euler"]["balances"] == true);
  CHECK(report["ordering"].size() == 2);
  CHECK(report["cl"] > 0.01);
  CHECK(report["bodies"].size() == 1);
  CHECK(report["bodies"][0]["name"] == "bump");
  for (const char* coefficient : {"cl", "cd", "cm", "cy", "roll", "yaw"}) CHECK(report.contains(coefficient));
  CHECK(report["reference"]["moment_centre"].size() == 3);
  for (const char* name : {"field.vtu", "surface.vtu", "history.csv", "report.json", "report.html", "surface.png",
                           "section.png", "cp.png", "history.png"})
    CHECK_MESSAGE(std::filesystem::exists(scratch.path() / "out" / name), name);
  CHECK(text_of(scratch.path() / "out/report.html").find("β = 0°") != std::string::npos);
  CHECK(text_of(scratch.path() / "out/report.html").find("on planes across the span") != std::string::npos);
  CHECK(text_of(scratch.path() / "out/report.html").find("<h2>Mass flow</h2>") != std::string::npos);

  // The field is that of the mesh's own cells and numbers, and a second run may start from it.
  const auto field = leonhard::io::read_mixed_mesh<3>(scratch.path() / "out/field.vtu");
  const auto mesh = leonhard::io::read_mixed_mesh<3>(scratch.path() / "channel.su2").mesh;
  CHECK(field.mesh.points == mesh.points);
  CHECK(field.mesh.kinds == mesh.kinds);
  // Over the bump's top the flow is faster than at the inlet: states are at their own vertices.
  for (const auto& values : field.point_fields)
    if (values.name == "mach") CHECK(values.values[6] > values.values[0] + 0.05);
  scratch.write("again.toml", head + boundaries("kind = \"slip-wall\"\n") +
                                  "[reference]\narea = 2\nmoment_centre = [1.5, 0.5, 0]\n[initial]\nfield = \"out/field.vtu\"\n");
  (void)run("solve again.toml -o again", scratch.path());
  const json again = json::parse(text_of(scratch.path() / "again/report.json"));
  CHECK(again["cl"].get<double>() == doctest::Approx(report["cl"].get<double>()).epsilon(1e-6));
}

TEST_CASE("sideslip_and_area_change_the_forces_as_they_should") {
  const ScratchFolder scratch;
  scratch.write("channel.su2", channel());
  const auto solve = [&](const std::string& flow, const std::string& reference) {
    std::string sides = boundaries("kind = \"slip-wall\"\n");
    for (const char* name : {"near", "far"}) {
      const std::string section = std::string("[boundary.") + name + "]\nkind = \"";
      sides.replace(sides.find(section) + section.size(), 8, "far-field");
    }
    scratch.write("case.toml", head + flow + sides + "[reference]\n" + reference);
    const auto ran = run("solve case.toml -o out --json", scratch.path());
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    return json::parse(ran.out);
  };
  const json one = solve("", "area = 1\n"), two = solve("", "area = 2\n"), slip = solve("beta_deg = 10\n", "area = 1\n");
  CHECK(one["cl"].get<double>() == doctest::Approx(2 * two["cl"].get<double>()).epsilon(1e-6));
  CHECK(slip["flow"]["beta_deg"] == 10);
  CHECK(std::abs(slip["cy"].get<double>() - one["cy"].get<double>()) > 1e-4);
}

TEST_CASE("viscous_flow_in_space_has_friction_on_its_walls") {
  const ScratchFolder scratch;
  scratch.write("channel.su2", channel());
  scratch.write("case.toml",
                head + "reynolds = 200\n" + boundaries("kind = \"no-slip-wall\"\n") + "[solver]\nresidual_drop_orders = 5\n");
  const auto ran = run("solve case.toml -o out --json", scratch.path());
  CAPTURE(ran.err);
  REQUIRE(ran.exit_code == 0);
  const json report = json::parse(ran.out);
  CHECK(report["cd_friction"] > 0.01);
  CHECK(report["walls"]["y_plus_max"] > 0);
}

TEST_CASE("keys_and_markers_that_a_mesh_of_space_has_no_use_for_are_refused_before_any_work") {
  const ScratchFolder scratch;
  scratch.write("channel.su2", channel());
  const auto refused = [&](const std::string& text, const std::string& words) {
    scratch.write("case.toml", text);
    for (const char* how : {" --dry-run", ""}) {
      const auto ran = run(std::string("solve case.toml -o out") + how, scratch.path());
      if (std::string(how).empty() || words.find("case.toml:") != std::string::npos) {
        CHECK(ran.exit_code == 2);
        CHECK_MESSAGE(ran.err.find(words) != std::string::npos, ran.err);
      }
    }
    CHECK_FALSE(std::filesystem::exists(scratch.path() / "out"));
  };
  const std::string good = boundaries("kind = \"slip-wall\"\n");
  refused(head + good + "[partition]\nparts = 4\n", "case.toml:17: partition.parts is given but the flow is one of space");
  refused(head + good + "[farfield]\nvortex_correction = false\n", "case.toml:17: farfield.vortex_correction is given but");
  refused(head + good + "[reference]\nmoment_centre = [0, 0]\n", "case.toml:17: reference.moment_centre = [0, 0] in a flow of space");
  refused(head + "[boundary.bump]\nkind = \"slip-wall\"\n", "has no condition");
}
