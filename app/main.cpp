// SPDX-License-Identifier: MIT
// The program leonhard: reads the command line, runs one subcommand, and turns its outcome into an exit code.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/exit_code.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/self_test.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"

namespace {

using leonhard::app::ExitCode;

int say(ExitCode code, const char* what) {
  std::fprintf(stderr, "leonhard: %s\n", what);
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) try {
  if (const auto broken = leonhard::kernel::floating_point_self_test()) {
    return say(ExitCode::bad_input, ("this build cannot decide exactly: " + *broken).c_str());
  }
  CLI::App program{
      "Exact Delaunay meshes, mesh graphs and finite-volume flow.\n"
      "Start with: leonhard solve examples/naca0012/transonic.toml",
      "leonhard"};
  program.set_version_flag("--version", std::string("leonhard ") + LEONHARD_VERSION);
  program.require_subcommand(1);
  program.failure_message(CLI::FailureMessage::help);
  ExitCode code = ExitCode::done;
  leonhard::app::add_commands(program, code);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& wish) {  // --help, --version
    return program.exit(wish);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "leonhard: %s\nRun leonhard --help, or leonhard SUBCOMMAND --help.\n", error.what());
    return static_cast<int>(ExitCode::wrong_usage);
  }
  return static_cast<int>(code);
} catch (const leonhard::InputError& error) {
  return say(ExitCode::bad_input, error.what());
} catch (const leonhard::OutputError& error) {
  return say(ExitCode::bad_input, error.what());
} catch (const std::bad_alloc&) {
  return say(ExitCode::bad_input, "out of memory: this machine has too little for a problem of this size");
} catch (const std::exception& error) {
  return say(ExitCode::bad_input, error.what());
}
