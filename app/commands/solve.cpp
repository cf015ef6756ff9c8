// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <memory>
#include <thread>

#include "leonhard/app/case/case.hpp"
#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/report/space_report.hpp"
#include "leonhard/app/report/staged_folder.hpp"
#include "leonhard/app/report/write.hpp"
#include "leonhard/app/solve/separation.hpp"
#include "leonhard/app/solve/space_steps.hpp"
#include "leonhard/app/solve/stage_clock.hpp"
#include "leonhard/app/solve/steps.hpp"
#include "leonhard/mesh/io/file_dimension.hpp"
#include "leonhard/solver/linear_solver.hpp"

namespace leonhard::app {
namespace {

struct SolveOptions {
  CommonOptions common;
  std::string case_file;
  bool dry_run = false;
};

/// One step: timed, then told on the console.
template <class Step>
void take(RunCommon& run, Console& console, const char* name, Step&& step) {
  std::string told;
  {
    StageClock clock(run, name);
    told = step();
  }
  console.stage(name, told, run.stages.back().seconds);
}

/// The way of the data in the plane, step by step (ARCHITECTURE.md).
void take_steps(SolveRun& run, const SolveOptions& options, Console& console, const std::stop_token& stop) {
  take(run, console, "geometry", [&] { return step_geometry(run); });
  take(run, console, "mesh", [&] { return step_mesh(run, stop); });
  take(run, console, "account", [&] { return step_account(run); });
  take(run, console, "order", [&] { return step_order(run); });
  take(run, console, "partition", [&] { return step_partition(run, options.common.seed, stop); });
  take(run, console, "march", [&] { return step_march(run, console, stop); });
}

/// And in space.
void take_steps(SpaceRun& run, const SolveOptions&, Console& console, const std::stop_token& stop) {
  take(run, console, "mesh", [&] { return space::step_mesh(run); });
  take(run, console, "account", [&] { return space::step_account(run); });
  take(run, console, "order", [&] { return space::step_order(run); });
  take(run, console, "march", [&] { return space::step_march(run, console, stop); });
}

/// Separation, where there are no-slip walls of the plane.
void tell_the_separation(const SolveRun& run) {
  for (const FrictionZero& zero : friction_zeros(run.flow))
    fmt::print("{} of the flow along {} at x {:.4f}, y {:.4f}\n", to_string(zero.kind), run.conditions.at(zero.marker).name,
               zero.at.x, zero.at.y);
}
void tell_the_separation(const SpaceRun&) {}

template <class Run>
void tell_the_end(const Run& run, const std::filesystem::path& folder) {
  const Forces& forces = run.flow.forces;
  fmt::print("{}\n", run.flow.words);
  fmt::print("CL {:.5f}   CD {:.5f}   CM {:.5f}\n", forces.cl, forces.cd, forces.cm);
  if (run.the_case.flow.reynolds)
    fmt::print("CD of pressure {:.5f}   of friction {:.5f}\n", forces.cd - forces.cd_friction, forces.cd_friction);
  if (const auto heights = wall_heights(run.flow))
    fmt::print("y+ of the first cells {:.3g} to {:.3g}\n", heights->least, heights->most);
  tell_the_separation(run);
  fmt::print("Report: {}\n", (folder / "report.html").string());
}

template <class Run>
ExitCode solve(Case the_case, const SolveOptions& options) {
  Run run;
  run.the_case = std::move(the_case);
  run.threads = options.common.threads > 0
                    ? options.common.threads
                    : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  Console console(options.common.quiet);
  const StopOnSignal signals;
  const std::stop_token stop = signals.token();
  StagedFolder output(run.the_case.output.folder);
  const PetscSession petsc;
  try {
    take_steps(run, options, console, stop);
  } catch (const StoppedEarly& early) {
    fmt::print(stderr, "leonhard: stopped {}; nothing was written\n", early.where);
    return ExitCode::stopped;
  }
  const Json report = write_report(run, output.stage());
  output.commit();
  console.stage("write", output.folder().string(), run.stages.back().seconds);
  for (const std::string& warning : run.warnings) console.warning(warning);
  if (options.common.json)
    fmt::print("{}\n", report.text());
  else
    tell_the_end(run, output.folder());
  if (run.flow.verdict == Verdict::stopped) return ExitCode::stopped;
  return run.goal_met() ? ExitCode::done : ExitCode::goal_not_met;
}

/// Of the mesh that a case names; bodies and domains are of the plane.
int dimension_of(const Case& c) { return c.mesh_file.empty() ? 2 : io::file_dimension(c.mesh_file); }

ExitCode solve(const SolveOptions& options) {
  Case c = read_case(options.case_file);
  if (!options.common.output.empty()) c.output.folder = options.common.output;
  const int dimension = dimension_of(c);
  require_dimension(c, dimension);
  if (options.dry_run) {
    fmt::print("{}", describe(c));
    return ExitCode::done;
  }
  return dimension == 2 ? solve<SolveRun>(std::move(c), options) : solve<SpaceRun>(std::move(c), options);
}

}  // namespace

Command solve_command() {
  const auto options = std::make_shared<SolveOptions>();
  Command command{
      .name = "solve",
      .help = "From a case file to its flow: mesh, proof, order, partition, march, report",
      .options = {{"case", "The case file (docs/case-file.md lists every key)", &options->case_file, true},
                  {"--dry-run", "Check the case and print every key with the value in force; do nothing",
                   &options->dry_run}},
      .run = [options] { return solve(*options); }};
  add_common_options(command, options->common, "Folder of the results (default: output.folder of the case)");
  return command;
}

}  // namespace leonhard::app
