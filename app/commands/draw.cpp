// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <array>
#include <memory>
#include <span>

#include "leonhard/app/commands/commands.hpp"
#include "leonhard/app/commands/tet_drawing.hpp"
#include "leonhard/app/console.hpp"
#include "leonhard/app/meshes/cut_cells.hpp"
#include "leonhard/app/meshes/read_request.hpp"
#include "leonhard/app/report/json.hpp"
#include "leonhard/app/report/matrix_picture.hpp"
#include "leonhard/app/report/picture_view.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/draw.hpp"
#include "leonhard/mesh/edges.hpp"
#include "leonhard/mesh/io/any_mesh_file.hpp"

namespace leonhard::app {
namespace {

struct DrawCommand {
  CommonOptions common;
  ReadRequest reading;
  std::string mesh;
  std::string what = "mesh";
  std::string field;
  std::vector<double> view;
  std::string cut;
  bool section = false;
  double perspective_deg = 0;
  std::array<int, 2> size{1600, 1000};
  std::uint32_t parts = 8;
  std::string title;
};

void draw_named_field(const DrawCommand& command, const AnyMeshFile& file, const TriangleMesh& mesh,
                      const draw::PictureSize& size) {
  draw::draw_field(
      command.common.output, mesh, lengths_of(io::finite_field(file, command.field, command.mesh)),
      {.size = size, .view = plane_view(command.view), .title = command.title, .value_label = command.field});
}

/// Options that need a third dimension are not left unused.
void check_plane(const DrawCommand& command) {
  const auto refuse = [&](const char* option) {
    throw InputError(option, command.mesh + " is a mesh of the plane", "leave the option out");
  };
  if (!command.cut.empty()) refuse("--cut");
  if (command.section) refuse("--section");
  if (command.perspective_deg != 0) refuse("--perspective");
  if (command.what == "markers") refuse("--what markers");
}

/// cell_of  the cell of which each triangle is a part, or empty
void draw_triangles(const DrawCommand& command, const AnyMeshFile& file, const TriangleMesh& mesh,
                    std::span<const std::size_t> cell_of) {
  check_plane(command);
  const draw::PictureSize size{command.size[0], command.size[1]};
  if (!command.field.empty()) {
    draw_named_field(command, file, mesh, size);
  } else if (command.what == "matrix") {
    const graph::CsrGraph graph = graph::vertex_graph(mesh, mesh::build_edges(mesh));
    draw_matrix(command.common.output, graph, both_numberings(graph), command.title, size);
  } else if (command.what == "partition") {
    const auto parts =
        graph::recursive_spectral_bisection(graph::dual_graph(mesh), command.parts, command.common.seed);
    draw::draw_partition(
        command.common.output, mesh, parts.part_of, parts.parts,
        {.size = size, .view = plane_view(command.view), .title = command.title, .cell_of = cell_of});
  } else {
    const auto fill = command.what == "quality"   ? draw::MeshFill::quality
                      : command.what == "regions" ? draw::MeshFill::region
                                                  : draw::MeshFill::none;
    draw::draw_mesh(command.common.output, mesh,
                    {.size = size,
                     .view = plane_view(command.view),
                     .title = command.title,
                     .fill = fill,
                     .cell_of = cell_of});
  }
}

void draw_tetrahedra(const DrawCommand& command, const AnyMeshFile& file, const TetMesh& mesh) {
  TetDrawing drawing;
  drawing.picture = command.common.output;
  drawing.what = command.what;
  drawing.cut = command.cut;
  drawing.section = command.section;
  drawing.view = command.view;
  drawing.perspective_deg = command.perspective_deg;
  drawing.size = command.size;
  drawing.title = command.title;
  drawing.parts = command.parts;
  drawing.seed = command.common.seed;
  if (!command.field.empty()) {
    drawing.field = command.field;
    drawing.field_values = lengths_of(io::finite_field(file, command.field, command.mesh));
  }
  draw_tets(drawing, mesh);
}

ExitCode draw_file(const DrawCommand& command) {
  AnyMeshFile file = io::read_any_mesh(command.mesh, command.reading.options());
  const CutCells cut = cut_cells(file);
  const bool shows_parts = file.dimension() == 3 || !command.field.empty() || command.what == "quality" ||
                           command.what == "matrix";
  if (shows_parts && !cut.words.empty()) file.warnings.push_back(cut.words);
  if (const TriangleMesh* triangles = std::get_if<TriangleMesh>(&file.mesh)) {
    draw_triangles(command, file, *triangles, cut.cell_of);
  } else {
    draw_tetrahedra(command, file, std::get<TetMesh>(file.mesh));
  }
  const std::vector<std::string>& warnings = file.warnings;
  Console console(command.common.quiet);
  for (const std::string& warning : warnings) console.warning(warning);
  if (command.common.json)
    fmt::print("{}\n", Json{{"picture", command.common.output}, {"warnings", warnings}}.text());
  return ExitCode::done;
}

}  // namespace

Command draw_command() {
  const auto options = std::make_shared<DrawCommand>();
  Command command{
      .name = "draw",
      .help = "A picture of a mesh, its quality, a field, a partition or its matrix",
      .options = {{"mesh", "A mesh file", &options->mesh, true},
                  {.names = "--what",
                   .help = "What to draw; markers of meshes of space, matrix of those of the plane",
                   .target = &options->what,
                   .shows_default = true,
                   .choices = {"mesh", "quality", "regions", "markers", "partition", "matrix"}},
                  {"--field", "A point field of the file, e.g. mach", &options->field},
                  {.names = "--parts",
                   .help = "Parts of the partition",
                   .target = &options->parts,
                   .shows_default = true,
                   .range = OptionRange{1, 100000}},
                  {.names = "--view",
                   .help = "Plane: xmin,ymin,xmax,ymax, the whole mesh otherwise. Space: azimuth,elevation "
                           "of the viewer in "
                           "degrees, otherwise -60,25",
                   .target = &options->view,
                   .length = OptionLength{2, 4}},
                  {"--cut",
                   "Space: what is cut away: none; x, y or z, through the middle; x=0.5, the side to the "
                   "viewer; x<0.5; "
                   "or nx,ny,nz,d, where nx x + ny y + nz z > d. Otherwise the half towards the viewer",
                   &options->cut},
                  {"--section",
                   "Space: cut along the plane, through tetrahedra, in place of leaving them whole",
                   &options->section},
                  {.names = "--perspective",
                   .help = "Space: field of view in degrees, 20 being mild; 0: parallel lines stay parallel",
                   .target = &options->perspective_deg,
                   .shows_default = true,
                   .range = OptionRange{0, 60}},
                  {.names = "--size",
                   .help = "Width,height in pixels",
                   .target = &options->size,
                   .shows_default = true},
                  {"--title", "Title of the picture", &options->title}},
      .run = [options] { return draw_file(*options); }};
  add_read_options(command, options->reading);
  add_common_options(command, options->common, "The picture: .png, .svg or .pdf", OutputFile::required);
  return command;
}

}  // namespace leonhard::app
