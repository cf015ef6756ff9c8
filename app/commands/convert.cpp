// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/meshes/read_request.hpp"
#include "leonhard/app/report/json.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/io/any_mesh_file.hpp"
#include "leonhard/mesh/io/extension.hpp"

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

ExitCode convert(const ConvertOptions& options) {
  AnyMeshFile file = io::read_any_mesh(options.in, options.reading.options());
  check_output(options, file);
  if (options.renumber)
    if (const std::string changed = io::renumber_markers(file); !changed.empty())
      file.warnings.push_back(changed);
  if (const std::string lost = io::left_behind(options.out, file); !lost.empty())
    file.warnings.push_back(io::small_extension(options.out) +
                            " files have no place for these, which were left behind: " + lost);
  io::write_any_mesh(options.out, file, {options.msh_version == "2.2", options.binary});
  if (!options.common.quiet) {
    Console console(false);
    for (const std::string& warning : file.warnings) console.warning(warning);
  }
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

}  // namespace

Command convert_command() {
  const auto options = std::make_shared<ConvertOptions>();
  Command command{
      .name = "convert",
      .help = "Read a mesh of the plane or of space in one format, write it in another; both by extension",
      .options =
          {{"in", "Mesh to read", &options->in, true},
           {"out", "Mesh to write", &options->out, true},
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
