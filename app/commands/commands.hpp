// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "leonhard/app/command_line/command.hpp"

namespace leonhard::app {

/// The flags that every subcommand knows.
struct CommonOptions {
  int threads = 0;  ///< 0: as many as there are cores
  std::uint64_t seed = 1;
  bool quiet = false;
  bool json = false;
  std::string output;  ///< -o; its meaning is the subcommand's
};

enum class OutputFile { optional, required };

/// Adds -o with the given description and --threads --seed --quiet --json to a subcommand.
///
/// options  is kept alive by the command's run
void add_common_options(Command& command, CommonOptions& options, const std::string& output_help,
                        OutputFile output = OutputFile::optional);

/// Every subcommand, in the order of the help.
[[nodiscard]] std::vector<Command> all_commands();

[[nodiscard]] Command solve_command();
[[nodiscard]] Command mesh_command();
[[nodiscard]] Command triangulate_command();
[[nodiscard]] Command tetrahedralize_command();
[[nodiscard]] Command voronoi_command();
[[nodiscard]] Command order_command();
[[nodiscard]] Command check_command();
[[nodiscard]] Command draw_command();
[[nodiscard]] Command partition_command();
[[nodiscard]] Command communicate_command();
[[nodiscard]] Command convert_command();

}  // namespace leonhard::app
