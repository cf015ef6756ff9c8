// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "leonhard/app/case/case.hpp"
#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/report/mesh_json.hpp"
#include "leonhard/app/report/mesh_report.hpp"
#include "leonhard/app/report/peak_memory.hpp"
#include "leonhard/app/solve/mesh_domain.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"

namespace leonhard::app {
namespace {

struct MeshOptions {
  CommonOptions common;
  std::string geometry;
  MesherCase mesher;
  double size = 0, max_area = 0;
  BodyCase body;
  FarFieldCase farfield;
};

/// A case that has the geometry and nothing else.
Case case_of(const MeshOptions& options) {
  const std::filesystem::path file = options.geometry;
  Case c;
  c.file = file;
  c.mesher = options.mesher;
  if (options.size > 0) c.mesher.size = options.size;
  c.farfield = options.farfield;
  if (file.extension() == ".poly") {
    c.domain_file = file;
  } else {
    c.bodies.push_back(options.body);
    c.bodies[0].file = file;
    c.bodies[0].name = file.stem().string();
    c.bodies[0].where = file.string();
  }
  return c;
}

ExitCode mesh(const MeshOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Console console(options.common.quiet);
  const StopOnSignal signals;
  const DomainGeometry domain = make_domain(case_of(options));
  const auto meshed = mesh_domain(domain, options.mesher, options.max_area, signals.token());
  for (const std::string& warning : mesh_warnings(meshed.report, options.mesher)) console.warning(warning);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  io::write_mesh(options.common.output, meshed.mesh);
  const MeshReport report = mesh_report(meshed.mesh);
  if (options.common.json) {
    Json json = to_json(report);
    json["refinement"] = to_json(meshed.report);
    json["seconds"] = Json{{"mesh", seconds}};
    json["peak_memory_bytes"] = peak_memory_bytes();
    fmt::print("{}\n", json.text());
  } else {
    fmt::print("{}{:<14}{}, {} points inserted\n", text_of(report), "refinement", to_string(meshed.report.outcome),
               grouped(meshed.report.inserted));
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
      .options = {{"geometry", "PSLG (.poly) or airfoil coordinates (.dat)", &options->geometry, true},
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
