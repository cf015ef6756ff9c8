// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"

namespace leonhard::app {
namespace {

struct ConvertOptions {
  CommonOptions common;
  std::string in, out;
};

ExitCode convert(const ConvertOptions& options) {
  const MeshFile file = io::read_mesh(options.in);
  io::write_mesh(options.out, file.mesh);
  Console console(options.common.quiet);
  for (const std::string& warning : file.warnings) console.warning(warning);
  if (options.common.json) {
    const Json report = {{"in", options.in},
                         {"out", options.out},
                         {"vertices", file.mesh.vertex_count()},
                         {"triangles", file.mesh.triangle_count()},
                         {"fingerprint", mesh::fingerprint(file.mesh).hex()},
                         {"warnings", file.warnings}};
    fmt::print("{}\n", report.dump(2));
  }
  return ExitCode::done;
}

}  // namespace

void add_convert(CLI::App& program, ExitCode& code) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      program.add_subcommand("convert", "Read a mesh in one format, write it in another; both by extension");
  command->add_option("in", options->in, "Mesh to read")->required();
  command->add_option("out", options->out, "Mesh to write")->required();
  command->add_flag("--quiet", options->common.quiet, "No warnings about the file's oddities");
  command->add_flag("--json", options->common.json, "One machine-readable report on stdout");
  command->callback([options, &code] { code = convert(*options); });
}

}  // namespace leonhard::app
