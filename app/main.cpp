// SPDX-License-Identifier: MIT
// The program leonhard: reads the command line, runs one subcommand, and turns its outcome into an exit code.

#include <cstdio>
#include <exception>
#include <string>

#include "leonhard/app/command_line/command_line.hpp"
#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/failure.hpp"
#include "leonhard/kernel/self_test.hpp"

namespace {

using namespace leonhard::app;

int say(const Failure& failure) {
  std::fprintf(stderr, "leonhard: %s\n", failure.message.c_str());
  return static_cast<int>(failure.code);
}

}  // namespace

int main(int argc, char** argv) try {
  if (const auto broken = leonhard::kernel::floating_point_self_test())
    return say({ExitCode::bad_input, "this build cannot decide exactly: " + *broken});
  const ProgramText text{
      .name = "leonhard",
      .description =
          "Exact Delaunay meshes, mesh graphs and finite-volume flow.\n"
          "Start with: leonhard solve examples/naca0012/transonic.toml",
      .version = std::string("leonhard ") + LEONHARD_VERSION,
      .footer =
          "Exit codes: 0 done, 1 wrong usage, 2 bad input or too little memory, 3 goal not met,\n"
          "4 stopped, 70 internal error"};
  return static_cast<int>(run_command_line(text, all_commands(), argc, argv));
} catch (...) {
  return say(failure_of(std::current_exception()));
}
