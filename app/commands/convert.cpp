// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/report/json.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/file_dimension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/tet_mesh_file.hpp"

namespace leonhard::app {
namespace {

struct ConvertOptions {
  CommonOptions common;
  std::string in, out;
};

struct Converted {
  Json counts;
  std::vector<std::string> warnings;
};

bool is_one_of(std::string extension, const std::vector<std::string>& known) {
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(known.begin(), known.end(), extension) != known.end();
}

/// A format for the other dimension only deserves better words than "unknown".
void check_output(const ConvertOptions& options, int dimension) {
  const std::string extension = std::filesystem::path(options.out).extension().string();
  const auto& own = dimension == 2 ? io::mesh_extensions() : io::tet_mesh_extensions();
  const auto& other = dimension == 2 ? io::tet_mesh_extensions() : io::mesh_extensions();
  if (is_one_of(extension, own) || !is_one_of(extension, other)) return;
  std::string known;
  for (const std::string& e : own) known += (known.empty() ? "" : " ") + e;
  throw InputError(options.out,
                   extension + " is written for meshes of " + (dimension == 2 ? "space" : "the plane") +
                       " only, and " + options.in + " is one of " + (dimension == 2 ? "the plane" : "space"),
                   "use one of " + known);
}

/// Leaves the fields out, with a warning, if the format of the output carries none.
template <class File>
void drop_fields_that_do_not_fit(File& file, const std::string& out) {
  const std::size_t count = file.point_fields.size() + file.cell_fields.size();
  if (count == 0 || io::carries_fields(out)) return;
  file.warnings.push_back(fmt::format("{} {} left out: {} files carry none", count,
                                      count == 1 ? "field was" : "fields were",
                                      std::filesystem::path(out).extension().string()));
  file.point_fields.clear();
  file.cell_fields.clear();
}

Converted convert_triangles(const ConvertOptions& options) {
  MeshFile file = io::read_mesh(options.in);
  drop_fields_that_do_not_fit(file, options.out);
  io::write_mesh(options.out, file.mesh, file.point_fields, file.cell_fields);
  return {Json{{"vertices", file.mesh.vertex_count()},
               {"triangles", file.mesh.triangle_count()},
               {"fingerprint", mesh::fingerprint(file.mesh).hex()}},
          std::move(file.warnings)};
}

Converted convert_tetrahedra(const ConvertOptions& options) {
  TetMeshFile file = io::read_tet_mesh(options.in);
  drop_fields_that_do_not_fit(file, options.out);
  io::write_tet_mesh(options.out, file.mesh, file.point_fields, file.cell_fields);
  return {Json{{"vertices", file.mesh.vertex_count()},
               {"tetrahedra", file.mesh.tet_count()},
               {"fingerprint", mesh::fingerprint(file.mesh).hex()}},
          std::move(file.warnings)};
}

ExitCode convert(const ConvertOptions& options) {
  const int dimension = io::file_dimension(options.in);
  check_output(options, dimension);
  const Converted converted = dimension == 3 ? convert_tetrahedra(options) : convert_triangles(options);
  Console console(options.common.quiet);
  for (const std::string& warning : converted.warnings) console.warning(warning);
  if (options.common.json) {
    Json report{{"in", options.in}, {"out", options.out}};
    report.update(converted.counts);
    report["warnings"] = converted.warnings;
    fmt::print("{}\n", report.text());
  }
  return ExitCode::done;
}

}  // namespace

Command convert_command() {
  const auto options = std::make_shared<ConvertOptions>();
  return {
      .name = "convert",
      .help = "Read a mesh of the plane or of space in one format, write it in another; both by extension",
      .options = {{"in", "Mesh to read", &options->in, true},
                  {"out", "Mesh to write", &options->out, true},
                  {"--quiet", "No warnings about the file's oddities", &options->common.quiet},
                  {"--json", "One machine-readable report on stdout", &options->common.json}},
      .run = [options] { return convert(*options); }};
}

}  // namespace leonhard::app
