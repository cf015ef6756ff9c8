// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/geometry/geometry_file.hpp"
#include "leonhard/app/meshes/read_request.hpp"
#include "leonhard/app/points/points_dimension.hpp"
#include "leonhard/app/points/read_any_points.hpp"
#include "leonhard/app/report/geometry_report.hpp"
#include "leonhard/app/report/mesh_groups.hpp"
#include "leonhard/app/report/mesh_report.hpp"
#include "leonhard/app/report/mixed_report.hpp"
#include "leonhard/app/report/points3_report.hpp"
#include "leonhard/app/report/points_report.hpp"
#include "leonhard/app/report/surface_report.hpp"
#include "leonhard/app/report/tet_report.hpp"
#include "leonhard/mesh/io/any_contents.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/file_dimension.hpp"
#include "leonhard/mesh/io/points3_file.hpp"
#include "leonhard/mesh/io/surface_account.hpp"
#include "leonhard/mesh/io/surface_file.hpp"

namespace leonhard::app {
namespace {

struct CheckOptions {
  CommonOptions common;
  ReadRequest reading;
  std::string file;
};

/// Report and text: to the files and streams that were asked for.
template <class Report>
void show(const CheckOptions& options, const Report& report, const std::vector<std::string>& warnings,
          const std::optional<MeshGroups>& groups = std::nullopt) {
  Json json = to_json(report);
  if (groups) json.update(to_json(*groups));
  json["warnings"] = warnings;
  if (!options.common.output.empty()) io::write_file_atomically(options.common.output, json.text() + "\n");
  if (options.common.json) {
    fmt::print("{}\n", json.text());
  } else {
    fmt::print("{}{}", text_of(report), groups ? text_of(*groups) : "");
    for (const std::string& warning : warnings) fmt::print("{:<14}{}\n", "warning", warning);
  }
}

MeshReport report_of(const TriangleMesh& mesh) { return mesh_report(mesh); }
TetReport report_of(const TetMesh& mesh) { return tet_mesh_report(mesh); }
template <int Dim>
MixedReport report_of(const MixedMesh<Dim>& mesh) {
  return mixed_report(mesh);
}

ExitCode check_mesh(const CheckOptions& options, const AnyMeshFile& file) {
  return std::visit(
      [&](const auto& mesh) {
        const auto report = report_of(mesh);
        show(options, report, file.warnings, mesh_groups(file));
        return report.is_sound() ? ExitCode::done : ExitCode::goal_not_met;
      },
      file.mesh);
}

delaunay::TriangulateOptions work_of(const CheckOptions& options, const StopOnSignal& signals) {
  delaunay::TriangulateOptions work;
  work.seed = options.common.seed;
  work.threads = static_cast<unsigned>(options.common.threads);
  work.progress.stop = signals.token();
  return work;
}

ExitCode check_geometry(const CheckOptions& options) {
  const StopOnSignal signals;
  GeometryFile file = read_any_geometry(options.file);
  const GeometryReport report = geometry_report(file.pslg, work_of(options, signals));
  file.warnings.insert(file.warnings.end(), report.repairs.begin(), report.repairs.end());
  show(options, report, file.warnings);
  if (report.outcome == delaunay::TriangulateOutcome::stopped) return ExitCode::stopped;
  return report.is_sound() ? ExitCode::done : ExitCode::goal_not_met;
}

ExitCode check_points(const CheckOptions& options) {
  const StopOnSignal signals;
  const GeometryFile file = read_any_geometry(options.file);
  delaunay::AlgorithmOptions work{
      .seed = options.common.seed, .threads = static_cast<unsigned>(options.common.threads), .progress = {}};
  work.progress.stop = signals.token();
  const PointsReport report = points_report(file.pslg.points, work);
  show(options, report, file.warnings);
  return report.outcome == delaunay::TriangulateOutcome::stopped ? ExitCode::stopped : ExitCode::done;
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

/// Formats that hold nothing but surfaces.
bool is_surface_file(const std::string& file) {
  static const std::vector<std::string> known{".off", ".obj", ".stl", ".ply", ".smesh"};
  return std::ranges::count(known, io::small_extension(file)) > 0;
}

ExitCode check_surface(const CheckOptions& options, SurfaceFile surface) {
  if (options.reading.weld >= 0) io::weld(surface, options.reading.weld);
  const SurfaceAccount account = io::surface_account(surface);
  show(options, account, surface.warnings);
  const bool sound = account.is_manifold() && account.is_oriented() && account.contacts == 0;
  return sound ? ExitCode::done : ExitCode::goal_not_met;
}

ExitCode check_contents(const CheckOptions& options) {
  AnyContents contents = io::read_any_contents(options.file, options.reading.options());
  if (auto* surface = std::get_if<SurfaceFile>(&contents)) return check_surface(options, std::move(*surface));
  if (const auto* mesh = std::get_if<AnyMeshFile>(&contents)) return check_mesh(options, *mesh);
  return check_geometry(options);
}

/// A .poly without the triangles or tetrahedra that would make it a mesh.
bool is_poly_alone(const std::filesystem::path& file) {
  return io::small_extension(file) == ".poly" &&
         !std::filesystem::exists(std::filesystem::path(file).replace_extension(".ele"));
}

/// Lines and polygons, or JSON that may have some.
bool is_shapes_file(const std::string& file) {
  static const std::vector<std::string> known{".wkt", ".geojson", ".json", ".dat"};
  return std::ranges::count(known, io::small_extension(file)) > 0;
}

ExitCode check(const CheckOptions& options) {
  if (is_shapes_file(options.file))
    return read_any_geometry(options.file).pslg.segments.empty() ? check_points(options)
                                                                 : check_geometry(options);
  if (is_points_file(options.file))
    return points_dimension(options.file) == 3 ? check_points3(options) : check_points(options);
  if (is_surface_file(options.file)) return check_surface(options, io::read_surface(options.file));
  if (is_poly_alone(options.file))
    return io::file_dimension(options.file) == 2 ? check_geometry(options)
                                                 : check_surface(options, io::read_surface(options.file));
  return check_contents(options);
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  Command command{
      .name = "check",
      .help =
          "Euler's account, validity, Delaunay property, quality and "
          "fingerprint of a mesh of the plane or of space, or an account of "
          "a surface, a geometry of the plane, or points",
      .options = {{"file", "A mesh, a surface, a geometry of the plane, or points", &options->file, true}},
      .run = [options] { return check(*options); }};
  add_read_options(command, options->reading);
  add_common_options(command, options->common, "Also write the report as JSON to this file");
  return command;
}

}  // namespace leonhard::app
