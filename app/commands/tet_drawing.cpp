// SPDX-License-Identifier: MIT
#include "leonhard/app/commands/tet_drawing.hpp"

#include <cmath>
#include <filesystem>

#include "leonhard/app/report/picture_view.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::app {
namespace {

void draw_field(const TetDrawing& drawing, const TetMesh& mesh, const draw::TetPictureOptions& options) {
  if (std::filesystem::path(drawing.mesh_file).extension() != ".vtu") {
    throw InputError(drawing.mesh_file, "only .vtu files carry fields such as " + drawing.field,
                     "give a .vtu");
  }
  const PointField field = io::read_vtu_field(drawing.mesh_file, drawing.field);
  std::vector<double> values(field.values.size() / field.components);
  for (std::size_t v = 0; v < values.size(); ++v) {  // a vector is drawn by its length
    double sum = 0;
    for (std::size_t i = 0; i < field.components; ++i)
      sum = std::hypot(sum, field.values[v * field.components + i]);
    values[v] = field.components == 1 ? field.values[v] : sum;
  }
  draw::draw_tet_field(drawing.picture, mesh, values, {.label = drawing.field}, options);
}

draw::TetFill fill_of(const std::string& what) {
  if (what == "markers") return draw::TetFill::marker;
  if (what == "regions") return draw::TetFill::region;
  if (what == "quality") return draw::TetFill::quality;
  return draw::TetFill::plain;
}

}  // namespace

void draw_tets(const TetDrawing& drawing, const TetMesh& mesh) {
  draw::TetPictureOptions options;
  options.size = {drawing.size[0], drawing.size[1]};
  options.title = drawing.title;
  options.view = space_view(drawing.view);
  options.view.field_of_view_deg = drawing.perspective_deg;
  if (drawing.section) options.cut = draw::CutStyle::planar;
  parse_cut(drawing.cut, draw::box_of(mesh), options);

  if (!drawing.field.empty()) return draw_field(drawing, mesh, options);
  if (drawing.what == "partition") {
    const auto parts =
        graph::recursive_spectral_bisection(graph::dual_graph(mesh), drawing.parts, drawing.seed);
    return draw::draw_tet_partition(drawing.picture, mesh, parts.part_of, parts.parts, options);
  }
  if (drawing.what == "matrix") {
    throw InputError("--what matrix", "the mesh is of space", "matrices are drawn of meshes of the plane");
  }
  draw::draw_tet_mesh(drawing.picture, mesh, fill_of(drawing.what), options);
}

}  // namespace leonhard::app
