// SPDX-License-Identifier: MIT
#include "leonhard/app/commands/tet_drawing.hpp"

#include <cmath>

#include "leonhard/app/report/picture_view.hpp"
#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

draw::TetFill fill_of(const std::string& what) {
  if (what == "markers") return draw::TetFill::marker;
  if (what == "regions") return draw::TetFill::region;
  if (what == "quality") return draw::TetFill::quality;
  return draw::TetFill::plain;
}

}  // namespace

std::vector<double> lengths_of(const PointField& field) {
  if (field.components == 1) return field.values;
  std::vector<double> lengths(field.values.size() / field.components);
  for (std::size_t v = 0; v < lengths.size(); ++v)
    for (std::size_t i = 0; i < field.components; ++i)
      lengths[v] = std::hypot(lengths[v], field.values[v * field.components + i]);
  return lengths;
}

void draw_tets(const TetDrawing& drawing, const TetMesh& mesh) {
  draw::TetPictureOptions options;
  options.size = {drawing.size[0], drawing.size[1]};
  options.title = drawing.title;
  options.view = space_view(drawing.view);
  options.view.field_of_view_deg = drawing.perspective_deg;
  if (drawing.section) options.cut = draw::CutStyle::planar;
  parse_cut(drawing.cut, draw::box_of(mesh), options);

  if (!drawing.field.empty())
    return draw::draw_tet_field(drawing.picture, mesh, drawing.field_values, {.label = drawing.field},
                                options);
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
