// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "leonhard/app/exit_code.hpp"

namespace CLI {
class App;
}

namespace leonhard::app {

/// The flags that every subcommand knows.
struct CommonOptions {
  int threads = 0;  ///< 0: as many as there are cores
  std::uint64_t seed = 1;
  bool quiet = false;
  bool json = false;
  std::string output;  ///< -o; its meaning is the subcommand's
};

/// Adds --threads --seed --quiet --json to a subcommand, and -o with the given description.
void add_common_flags(CLI::App& command, CommonOptions& options, const std::string& output_help);

/// Adds every subcommand; the one that is parsed runs and leaves its outcome in code.
void add_commands(CLI::App& program, ExitCode& code);

void add_solve(CLI::App& program, ExitCode& code);
void add_mesh(CLI::App& program, ExitCode& code);
void add_triangulate(CLI::App& program, ExitCode& code);
void add_tetrahedralize(CLI::App& program, ExitCode& code);
void add_voronoi(CLI::App& program, ExitCode& code);
void add_order(CLI::App& program, ExitCode& code);
void add_check(CLI::App& program, ExitCode& code);
void add_draw(CLI::App& program, ExitCode& code);
void add_partition(CLI::App& program, ExitCode& code);
void add_communicate(CLI::App& program, ExitCode& code);
void add_convert(CLI::App& program, ExitCode& code);

}  // namespace leonhard::app
