// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>

#include "leonhard/app/case/case.hpp"
#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/geometry/crossings_option.hpp"
#include "leonhard/app/geometry/geometry_file.hpp"
#include "leonhard/app/report/mesh_json.hpp"
#include "leonhard/app/report/mesh_report.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/app/solve/mesh_domain.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/airfoil_dat.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"

namespace leonhard::app {
namespace {

struct MeshOptions {
  CommonOptions common;
  std::string geometry;
  MesherCase mesher;
  double size = 0, max_area = 0, chord = 0;
  std::string crossings;
  bool convex_hull = false;
  BodyCase body;
  FarFieldCase farfield;
};

/// What there is to mesh, and what had to be decided to read it.
struct MeshInput {
  Case the_case;
  std::optional<Pslg> domain;  ///< none: bodies in a far field
  std::vector<std::string> warnings;
  bool is_guess = false;  ///< that the domain's points in order are its outline
};

/// Whether coordinates without a name are those of an airfoil: a long section that begins and ends at its larger x.
bool looks_like_airfoil(const std::filesystem::path& file) {
  try {
    constexpr std::size_t fewest = 12;
    constexpr double slender = 2.5;
    for (const AirfoilCoordinates& element : io::read_airfoils(file)) {
      const auto [left, right] = std::ranges::minmax(element.points, {}, &Point2::x);
      const auto [low, high] = std::ranges::minmax(element.points, {}, &Point2::y);
      const bool is_slender = right.x - left.x > slender * (high.y - low.y);
      if (element.points.size() < fewest || !is_slender) return false;
    }
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// The longest element's extent along x.
double chord_of(const std::vector<AirfoilCoordinates>& elements) {
  double chord = 0;
  for (const AirfoilCoordinates& element : elements) {
    const auto [low, high] = std::ranges::minmax(element.points, {}, &Point2::x);
    chord = std::max(chord, high.x - low.x);
  }
  return chord;
}

/// Bodies of a file of airfoil coordinates, lengths in chords.
void add_bodies(const MeshOptions& options, const std::filesystem::path& file, MeshInput& input) {
  const std::vector<AirfoilCoordinates> elements = io::read_airfoils(file);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    BodyCase body = options.body;
    body.file = file;
    body.where = file.string();
    body.name = file.stem().string();
    if (elements.size() > 1) {
      body.element = i + 1;
      body.name += fmt::format("_{}", i + 1);
    }
    body.leading_edge_spacing = body.trailing_edge_spacing = body.spacing / 3;
    input.the_case.bodies.push_back(body);
    input.warnings.insert(input.warnings.end(), elements[i].warnings.begin(), elements[i].warnings.end());
  }
  const double found = chord_of(elements);
  input.the_case.reference.length = options.chord > 0 ? options.chord : found;
  constexpr double about_one = 0.1;
  if (options.chord == 0 && std::abs(found - 1) > about_one)
    input.warnings.push_back(
        fmt::format("the chord is {:.6g}{}; lengths given in chords count in it (--chord)", found,
                    std::abs(found - 100) < 1 ? ", percent of a chord" : ""));
  constexpr double least_edges = 48;  // of the far field, as a case has them
  FarFieldCase& farfield = input.the_case.farfield;
  farfield.spacing = farfield.distance * std::min(options.mesher.growth, 2 * std::numbers::pi / least_edges);
}

/// A case that has the geometry and nothing else.
MeshInput read_geometry(const MeshOptions& options) {
  const std::filesystem::path file = options.geometry;
  MeshInput input;
  input.the_case.file = file;
  input.the_case.mesher = options.mesher;
  if (options.size > 0) input.the_case.mesher.size = options.size;
  input.the_case.farfield = options.farfield;
  const std::string extension = io::known_extension(file, any_geometry_extensions(), "geometry");
  const bool is_columns =
      extension == ".xy" || extension == ".xyz" || extension == ".csv" || extension == ".txt";
  if (extension == ".dat" || (is_columns && looks_like_airfoil(file))) {
    if (extension != ".dat") input.warnings.push_back(file.string() + " was taken for an airfoil");
    add_bodies(options, file, input);
    return input;
  }
  GeometryFile geometry = read_any_geometry(file);
  if (geometry.pslg.segments.empty()) {
    geometry = as_outline(std::move(geometry));
    geometry.warnings.push_back(file.string() +
                                " was taken for the outline of a domain, its points in order");
    input.is_guess = true;
  }
  input.warnings = std::move(geometry.warnings);
  input.domain = std::move(geometry.pslg);
  input.the_case.domain_file = file;
  return input;
}

ExitCode mesh(const MeshOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Console console(options.common.quiet);
  const StopOnSignal signals;
  const MeshInput input = read_geometry(options);
  DomainGeometry domain =
      input.domain ? make_domain(input.the_case, *input.domain) : make_domain(input.the_case);
  std::vector<std::string> warnings = input.warnings;
  for (const std::string& warning : warnings) console.warning(warning);
  domain.keep_convex_hull = options.convex_hull;
  MesherCase mesher = options.mesher;
  // An outline that was guessed and crosses itself is none.
  mesher.crossings = crossings_named(options.crossings, input.is_guess ? delaunay::Crossings::reject : delaunay::Crossings::split);
  const auto meshed = mesh_domain(domain, mesher, options.max_area, signals.token());
  for (const std::string& warning : mesh_warnings(meshed.report, options.mesher)) {
    console.warning(warning);
    warnings.push_back(warning);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  io::write_mesh(options.common.output, meshed.mesh);
  const MeshReport report = mesh_report(meshed.mesh);
  if (options.common.json) {
    Json json = to_json(report);
    json["refinement"] = to_json(meshed.report);
    json["input"] = options.geometry;
    json["output"] = options.common.output;
    json["warnings"] = warnings;
    // Of bodies in a far field the mesher's points are not the file's.
    if (input.domain) json["merged_points"] = merged_points_json(meshed.vertex_of_input);
    json["seconds"] = Json{{"mesh", seconds}};
    json["peak_memory_bytes"] = peak_memory_bytes();
    fmt::print("{}\n", json.text());
  } else {
    fmt::print("{}{:<14}{}, {} points inserted\n", text_of(report), "refinement",
               to_string(meshed.report.outcome), grouped(meshed.report.inserted));
  }
  switch (meshed.report.outcome) {
    case delaunay::RefineOutcome::achieved:
    case delaunay::RefineOutcome::small_angles_left:
      return ExitCode::done;
    case delaunay::RefineOutcome::vertex_budget_spent:
      return ExitCode::goal_not_met;
    case delaunay::RefineOutcome::stopped:
      return ExitCode::stopped;
  }
  return ExitCode::done;
}

}  // namespace

Command mesh_command() {
  const auto options = std::make_shared<MeshOptions>();
  options->common.output = "mesh.su2";
  Command command{
      .name = "mesh",
      .help = "A quality mesh of a planar straight-line graph or about an airfoil",
      .options =
          {{"geometry",
            "A domain (.poly .wkt .geojson, the marked edges of .msh .mesh), its outline (.xy .csv .txt) or "
            "airfoil "
            "coordinates (.dat)",
            &options->geometry, true},
           {.names = "--min-angle",
            .help = "No angle below this, degrees",
            .target = &options->mesher.min_angle_deg,
            .shows_default = true,
            .range = OptionRange{0, 34}},
           {.names = "--size",
            .help = "Largest edge length",
            .target = &options->size,
            .rule = OptionRule::positive},
           {.names = "--max-area",
            .help = "Largest triangle",
            .target = &options->max_area,
            .rule = OptionRule::positive},
           {.names = "--max-vertices",
            .help = "Stop at this many vertices",
            .target = &options->mesher.max_vertices,
            .shows_default = true},
           crossings_option(&options->crossings),
           {"--convex-hull",
            "Domains: keep the convex hull, carving holes only; otherwise all outside the segments goes",
            &options->convex_hull},
           {.names = "--growth",
            .help = "Airfoils: growth of the edge length per unit of distance",
            .target = &options->mesher.growth,
            .shows_default = true,
            .range = OptionRange{0, 10}},
           {.names = "--spacing",
            .help = "Airfoils: edge length on the body, chords",
            .target = &options->body.spacing,
            .shows_default = true,
            .rule = OptionRule::positive},
           {.names = "--chord",
            .help = "Airfoils: the length of a chord; otherwise the longest element's extent along x",
            .target = &options->chord,
            .rule = OptionRule::positive},
           {.names = "--distance",
            .help = "Airfoils: radius of the far field, chords",
            .target = &options->farfield.distance,
            .shows_default = true,
            .rule = OptionRule::positive}},
      .run = [options] { return mesh(*options); }};
  add_common_options(command, options->common,
                     "The mesh file; its extension is its format (default mesh.su2)");
  return command;
}

}  // namespace leonhard::app
