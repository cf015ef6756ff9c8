// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "leonhard/app/command_line/command.hpp"

namespace leonhard::app {

/// What the program says of itself.
struct ProgramText {
  std::string name;
  std::string description;
  std::string version;  ///< what --version prints
  std::string footer;   ///< below the help of the program
};

/// Read a command line and run the one subcommand that it names. --help and --version print to stdout, what is wrong with
/// the line goes to stderr.
///
/// arguments  of main(), the program's name first
/// returns    wrong_usage, or what the subcommand returns
/// throws     what the subcommand throws
[[nodiscard]] ExitCode run_command_line(const ProgramText& program, const std::vector<Command>& commands,
                                        int argument_count, const char* const* arguments);

}  // namespace leonhard::app
