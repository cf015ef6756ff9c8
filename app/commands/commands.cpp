// SPDX-License-Identifier: MIT
#include "leonhard/app/commands/commands.hpp"

#include <CLI/CLI.hpp>

namespace leonhard::app {

void add_common_flags(CLI::App& command, CommonOptions& options, const std::string& output_help) {
  command.add_option("-o,--output", options.output, output_help);
  command.add_option("--threads", options.threads, "Threads to use; 0 takes all cores")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Seed of everything that draws random numbers")
      ->capture_default_str();
  command.add_flag("--quiet", options.quiet, "No progress on stderr");
  command.add_flag("--json", options.json, "One machine-readable report on stdout");
}

void add_commands(CLI::App& program, ExitCode& code) {
  add_solve(program, code);
  add_mesh(program, code);
  add_triangulate(program, code);
  add_tetrahedralize(program, code);
  add_voronoi(program, code);
  add_order(program, code);
  add_check(program, code);
  add_draw(program, code);
  add_partition(program, code);
  add_communicate(program, code);
  add_convert(program, code);
}

}  // namespace leonhard::app
