// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/triangulate.hpp"

#include <fmt/core.h>

#include <memory>
#include <optional>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/geometry/crossings_option.hpp"
#include "leonhard/app/geometry/geometry_file.hpp"
#include "leonhard/app/report/lap_timer.hpp"
#include "leonhard/app/report/mesh_json.hpp"
#include "leonhard/app/report/mesh_report.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/app/report/points_report.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"

namespace leonhard::app {
namespace {

struct TriangulateCommand {
  CommonOptions common;
  std::string input, algorithm = "fast", crossings;
  bool convex_hull = false;
};

delaunay::TriangulateOptions options_of(const TriangulateCommand& command, Console& console,
                                        const StopOnSignal& signals) {
  delaunay::TriangulateOptions options;
  options.keep_convex_hull = command.convex_hull;
  options.crossings = crossings_named(command.crossings, delaunay::Crossings::split);
  options.algorithm = delaunay::algorithm_named(command.algorithm).value_or(delaunay::Algorithm::fast);
  options.threads = static_cast<unsigned>(command.common.threads);
  options.seed = command.common.seed;
  options.progress.stop = signals.token();
  options.progress.report = [&console](std::string_view stage, double fraction) {
    console.transient(fmt::format("{:<11}{:3.0f} %", stage, 100 * fraction));
  };
  return options;
}

ExitCode exit_code_of(delaunay::TriangulateOutcome outcome) {
  switch (outcome) {
    case delaunay::TriangulateOutcome::done:
      return ExitCode::done;
    case delaunay::TriangulateOutcome::stopped:
      return ExitCode::stopped;
    default:
      return ExitCode::goal_not_met;
  }
}

ExitCode triangulate(const TriangulateCommand& command) {
  LapTimer timer;
  Console console(command.common.quiet);
  const StopOnSignal signals;
  io::known_extension(command.common.output, io::mesh_extensions(), "mesh");  // before any work
  GeometryFile input = read_any_geometry(command.input);
  timer.lap("read");
  auto result = delaunay::triangulate(input.pslg, options_of(command, console, signals));
  timer.lap("triangulate");
  if (signals.token().stop_requested()) result.outcome = delaunay::TriangulateOutcome::stopped;
  input.warnings.insert(input.warnings.end(), result.repairs.begin(), result.repairs.end());
  for (const std::string& warning : input.warnings) console.warning(warning);

  const PointsAccount account = points_account(input.pslg.points);
  std::string words = why_no_triangles(result.outcome, account.distinct());
  if (!words.empty()) words = command.input + ": " + words;
  std::optional<MeshReport> report;  // none where there is no mesh
  if (result.outcome == delaunay::TriangulateOutcome::done) {
    report = mesh_report(result.mesh);
    timer.lap("check");
    io::write_mesh(command.common.output, result.mesh);
    timer.lap("write");
  }
  if (command.common.json) {
    Json json{
        {"input", command.input}, {"algorithm", command.algorithm}, {"outcome", to_string(result.outcome)}};
    json.update(to_json(account));
    json["words"] = words.empty() ? Json() : Json(words);
    if (report) {
      json.update(to_json(*report));
      json["output"] = command.common.output;
    }
    json["merged_points"] = merged_points_json(result.vertex_of_input);
    json["warnings"] = input.warnings;
    json["seconds"] = timer.seconds();
    json["peak_memory_bytes"] = peak_memory_bytes();
    fmt::print("{}\n", json.text());
  } else if (report) {
    fmt::print("{:<14}{}, {} duplicates merged\n{}", "points", grouped(account.points),
               grouped(account.duplicates), text_of(*report));
  }
  if (!words.empty()) fmt::print(stderr, "leonhard: {}\n", words);
  return exit_code_of(result.outcome);
}

std::vector<std::string> algorithm_names() {
  std::vector<std::string> names;
  for (const delaunay::NamedAlgorithm& known : delaunay::named_algorithms) names.emplace_back(known.name);
  return names;
}

}  // namespace

Command triangulate_command() {
  const auto options = std::make_shared<TriangulateCommand>();
  options->common.output = "mesh.su2";
  Command command{
      .name = "triangulate",
      .help = "The Delaunay triangulation of points, constrained where there are segments",
      .options = {{"points",
                   "Points (.node .xy .csv .txt .json) or a PSLG (.poly .wkt .geojson .dat, the marked edges "
                   "of .msh .mesh)",
                   &options->input, true},
                  {.names = "--algorithm",
                   .help = "The way to the triangulation, which is the same for all",
                   .target = &options->algorithm,
                   .shows_default = true,
                   .choices = algorithm_names()},
                  crossings_option(&options->crossings),
                  {"--convex-hull",
                   "PSLG: keep the convex hull, carving holes only; otherwise all outside the segments goes",
                   &options->convex_hull}},
      .run = [options] { return triangulate(*options); }};
  add_common_options(command, options->common,
                     "The mesh file; its extension is its format (default mesh.su2)");
  return command;
}

}  // namespace leonhard::app
