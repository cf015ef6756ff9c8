// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <memory>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/points/points_dimension.hpp"
#include "leonhard/app/points/read_any_points.hpp"
#include "leonhard/app/report/mesh_report.hpp"
#include "leonhard/app/report/points3_report.hpp"
#include "leonhard/app/report/points_report.hpp"
#include "leonhard/app/report/tet_report.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/file_dimension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/points3_file.hpp"
#include "leonhard/mesh/io/tet_mesh_file.hpp"

namespace leonhard::app {
namespace {

struct CheckOptions {
  CommonOptions common;
  std::string file;
};

/// Report and text: to the files and streams that were asked for.
template <class Report>
void show(const CheckOptions& options, const Report& report, const std::vector<std::string>& warnings) {
  Json json = to_json(report);
  json["warnings"] = warnings;
  if (!options.common.output.empty()) io::write_file_atomically(options.common.output, json.text() + "\n");
  if (options.common.json) {
    fmt::print("{}\n", json.text());
  } else {
    fmt::print("{}", text_of(report));
    for (const std::string& warning : warnings) fmt::print("{:<14}{}\n", "warning", warning);
  }
}

ExitCode check_mesh(const CheckOptions& options) {
  const MeshFile file = io::read_mesh(options.file);
  const MeshReport report = mesh_report(file.mesh);
  show(options, report, file.warnings);
  return report.is_sound() ? ExitCode::done : ExitCode::goal_not_met;
}

ExitCode check_points(const CheckOptions& options) {
  const StopOnSignal signals;
  const PointsFile file = read_any_points(options.file);
  delaunay::AlgorithmOptions work{
      .seed = options.common.seed, .threads = static_cast<unsigned>(options.common.threads), .progress = {}};
  work.progress.stop = signals.token();
  const PointsReport report = points_report(file.set.points, work);
  show(options, report, file.warnings);
  return report.outcome == delaunay::TriangulateOutcome::stopped ? ExitCode::stopped : ExitCode::done;
}

ExitCode check_tet_mesh(const CheckOptions& options) {
  const TetMeshFile file = io::read_tet_mesh(options.file);
  const TetReport report = tet_mesh_report(file.mesh);
  show(options, report, file.warnings);
  return report.is_sound() ? ExitCode::done : ExitCode::goal_not_met;
}

ExitCode check_points3(const CheckOptions& options) {
  const StopOnSignal signals;
  const Points3File file = io::read_points3(options.file);
  delaunay::TetrahedralizeOptions work;
  work.seed = options.common.seed;
  work.threads = static_cast<unsigned>(options.common.threads);
  work.progress.stop = signals.token();
  const Points3Report report = points3_report(file.set.points, work);
  show(options, report, file.warnings);
  return report.outcome == delaunay::TetrahedralizeOutcome::stopped ? ExitCode::stopped : ExitCode::done;
}

ExitCode check(const CheckOptions& options) {
  if (is_points_file(options.file)) {
    return points_dimension(options.file) == 3 ? check_points3(options) : check_points(options);
  }
  return io::file_dimension(options.file) == 3 ? check_tet_mesh(options) : check_mesh(options);
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  Command command{.name = "check",
                  .help =
                      "Euler's account, validity, Delaunay property, quality and "
                      "fingerprint of a mesh of the plane or of space, or an account of "
                      "points",
                  .options = {{"file", "A mesh file, or points", &options->file, true}},
                  .run = [options] { return check(*options); }};
  add_common_options(command, options->common, "Also write the report as JSON to this file");
  return command;
}

}  // namespace leonhard::app
