// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/meshes/read_request.hpp"
#include "leonhard/app/report/json.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/io/any_contents.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/surface_account.hpp"
#include "leonhard/mesh/io/surface_file.hpp"

namespace leonhard::app {
namespace {

struct ConvertOptions {
  CommonOptions common;
  ReadRequest reading;
  bool renumber = false, binary = false;
  std::string msh_version = "4.1";
  std::string in, out;
};

std::string list_of(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : " ") + word;
  return list;
}

/// A format for other meshes only deserves better words than "unknown".
void check_output(const ConvertOptions& options, const AnyMeshFile& file) {
  const std::string extension = io::small_extension(options.out);
  const std::vector<std::string> own = io::any_mesh_output_extensions(file);
  const auto knows = [&](const std::vector<std::string>& known) {
    return std::find(known.begin(), known.end(), extension) != known.end();
  };
  if (knows(own)) return;
  const bool plane = file.dimension() == 2, mixed = file.mesh.index() > 1;
  const AnyMeshFile triangles{TriangleMesh{}, {}, {}, {}}, tets{TetMesh{}, {}, {}, {}};
  if (mixed && knows(io::any_mesh_output_extensions(plane ? triangles : tets)))
    throw InputError(options.out,
                     extension + " files hold " + (plane ? "triangles" : "tetrahedra") + " alone, and " +
                         options.in + " has other cells",
                     "add --split, or use one of " + list_of(own));
  if (knows(io::any_mesh_output_extensions(plane ? tets : triangles)))
    throw InputError(options.out,
                     extension + " is written for meshes of " + (plane ? "space" : "the plane") +
                         " only, and " + options.in + " is one of " + (plane ? "the plane" : "space"),
                     "use one of " + list_of(own));
}

void add_counts(Json& report, const TriangleMesh& mesh) { report["triangles"] = mesh.triangle_count(); }
void add_counts(Json& report, const TetMesh& mesh) { report["tetrahedra"] = mesh.tet_count(); }
template <int Dim>
void add_counts(Json& report, const MixedMesh<Dim>& mesh) {
  report["cells"] = mesh.cell_count();
  for (std::size_t k = 0; k < cell_kind_count; ++k)
    if (const auto& shape = shape_of(static_cast<CellKind>(k)); shape.dimension == Dim)
      report[shape.names] = mesh.count_of(shape.kind);
}

void tell(const ConvertOptions& options, const std::vector<std::string>& warnings) {
  if (options.common.quiet) return;
  Console console(false);
  for (const std::string& warning : warnings) console.warning(warning);
}

ExitCode convert_surface(const ConvertOptions& options, SurfaceFile surface) {
  const auto& known = io::surface_output_extensions();
  const std::string extension = io::small_extension(options.out);
  if (std::ranges::count(known, extension) == 0)
    throw InputError(options.out, options.in + " is a surface, which " + extension + " files do not hold",
                     "use one of " + list_of(known));
  if (options.reading.weld >= 0) io::weld(surface, options.reading.weld);
  if (const std::string lost = io::write_surface(options.out, surface); !lost.empty())
    surface.warnings.push_back(extension + " files have no place for these, which were left behind: " + lost);
  tell(options, surface.warnings);
  if (options.common.json) {
    const Json report{{"in", options.in},
                      {"out", options.out},
                      {"vertices", surface.set.points.size()},
                      {"polygons", surface.polygon_count()},
                      {"warnings", surface.warnings}};
    fmt::print("{}\n", report.text());
  }
  return ExitCode::done;
}

ExitCode convert_mesh(const ConvertOptions& options, AnyMeshFile file) {
  check_output(options, file);
  if (options.renumber)
    if (const std::string changed = io::renumber_markers(file); !changed.empty())
      file.warnings.push_back(changed);
  if (const std::string lost = io::left_behind(options.out, file); !lost.empty())
    file.warnings.push_back(io::small_extension(options.out) +
                            " files have no place for these, which were left behind: " + lost);
  io::write_any_mesh(options.out, file, {options.msh_version == "2.2", options.binary});
  tell(options, file.warnings);
  if (options.common.json) {
    Json report{{"in", options.in}, {"out", options.out}};
    std::visit(
        [&](const auto& mesh) {
          report["vertices"] = mesh.vertex_count();
          add_counts(report, mesh);
          report["fingerprint"] = mesh::fingerprint(mesh).hex();
        },
        file.mesh);
    report["warnings"] = file.warnings;
    fmt::print("{}\n", report.text());
  }
  return ExitCode::done;
}

/// Formats of surfaces alone.
bool is_surface_file(const std::string& file) {
  const auto& meshes = io::any_mesh_extensions();
  const std::string extension = io::small_extension(file);
  return std::ranges::count(io::surface_extensions(), extension) > 0 &&
         std::ranges::count(meshes, extension) == 0;
}

ExitCode convert(const ConvertOptions& options) {
  if (is_surface_file(options.in)) return convert_surface(options, io::read_surface(options.in));
  AnyContents contents = io::read_any_contents(options.in, options.reading.options());
  if (auto* surface = std::get_if<SurfaceFile>(&contents))
    return convert_surface(options, std::move(*surface));
  if (auto* mesh = std::get_if<AnyMeshFile>(&contents)) return convert_mesh(options, std::move(*mesh));
  throw InputError(options.in, "the file holds edges and no cells",
                   "make a mesh of it first (leonhard mesh)");
}

}  // namespace

Command convert_command() {
  const auto options = std::make_shared<ConvertOptions>();
  Command command{
      .name = "convert",
      .help =
          "Read a mesh of the plane or of space, or a surface, in one format, write it in another; both by "
          "extension",
      .options =
          {{"in", "Mesh or surface to read", &options->in, true},
           {"out", "Mesh or surface to write", &options->out, true},
           {"--renumber-markers",
            "Positive whole numbers in place of negative markers and regions, for formats without signs",
            &options->renumber},
           {.names = "--msh-version",
            .help = "Of a .msh to write",
            .target = &options->msh_version,
            .shows_default = true,
            .choices = {"2.2", "4.1"}},
           {"--binary", "Write a .msh in binary", &options->binary}},
      .run = [options] { return convert(*options); }};
  add_read_options(command, options->reading);
  command.options.push_back({"--quiet", "No warnings about the file's oddities", &options->common.quiet});
  command.options.push_back({"--json", "One machine-readable report on stdout", &options->common.json});
  return command;
}

}  // namespace leonhard::app
