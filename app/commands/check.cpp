// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/report/mesh_report.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"

namespace leonhard::app {
namespace {

struct CheckOptions {
  CommonOptions common;
  std::string mesh;
};

ExitCode check(const CheckOptions& options) {
  const MeshFile file = io::read_mesh(options.mesh);
  Json report = mesh_report(file.mesh);
  report["warnings"] = file.warnings;
  if (!options.common.output.empty()) io::write_file_atomically(options.common.output, report.dump(2) + "\n");
  if (options.common.json) {
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{}", mesh_report_text(report));
    for (const std::string& warning : file.warnings) fmt::print("{:<14}{}\n", "warning", warning);
  }
  return is_sound(report) ? ExitCode::done : ExitCode::goal_not_met;
}

}  // namespace

void add_check(CLI::App& program, ExitCode& code) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = program.add_subcommand(
      "check", "Euler's account, validity, Delaunay property, quality and fingerprint of a mesh");
  command->add_option("mesh", options->mesh, "A mesh file")->required();
  add_common_flags(*command, options->common, "Also write the report as JSON to this file");
  command->callback([options, &code] { code = check(*options); });
}

}  // namespace leonhard::app
