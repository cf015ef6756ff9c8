// SPDX-License-Identifier: MIT
#include "leonhard/app/commands/commands.hpp"

namespace leonhard::app {

void add_common_options(Command& command, CommonOptions& options, const std::string& output_help,
                        OutputFile output) {
  const std::vector<Option> common{
      {"-o,--output", output_help, &options.output, output == OutputFile::required},
      {.names = "--threads",
       .help = "Threads to use; 0 takes all cores",
       .target = &options.threads,
       .shows_default = true,
       .range = OptionRange{0, 1024}},
      {.names = "--seed",
       .help = "Seed of everything that draws random numbers",
       .target = &options.seed,
       .shows_default = true},
      {"--quiet", "No progress on stderr", &options.quiet},
      {"--json", "One machine-readable report on stdout", &options.json}};
  command.options.insert(command.options.end(), common.begin(), common.end());
}

std::vector<Command> all_commands() {
  return {solve_command(),     mesh_command(),        triangulate_command(), tetrahedralize_command(),
          voronoi_command(),   order_command(),       check_command(),       draw_command(),
          partition_command(), communicate_command(), convert_command()};
}

}  // namespace leonhard::app
