// SPDX-License-Identifier: MIT
#include "leonhard/app/commands/tet_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include "leonhard/graph/mesh_graph.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/vtu.hpp"

namespace leonhard::app {
namespace {

std::optional<double> number_of(std::string_view words) {
  double value = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), value);
  if (error != std::errc{} || end != words.data() + words.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

[[noreturn]] void refuse_cut(const std::string& words) {
  throw InputError(
      "--cut", "'" + words + "' is no plane",
      "give none, an axis (x), its position (x=0.5), the side to remove (x<0.5), or nx,ny,nz,d for the "
      "plane nx x + ny y + nz z = d");
}

draw::CutPlane plane_across(const std::string& words, const draw::Box3& box, const draw::View3& view) {
  const auto axis = static_cast<draw::Axis3>(words[0] - 'x');
  const auto middle = [](double low, double high) { return low / 2 + high / 2; };
  const std::array<double, 3> middles{middle(box.low.x, box.high.x), middle(box.low.y, box.high.y),
                                      middle(box.low.z, box.high.z)};
  if (words.size() == 1) return draw::cut_across(axis, middles[static_cast<std::size_t>(axis)], view);
  const auto position = number_of(std::string_view(words).substr(2));
  if (!position || (words[1] != '=' && words[1] != '<' && words[1] != '>')) refuse_cut(words);
  draw::CutPlane plane = draw::cut_across(axis, *position, view);
  if (words[1] == '=') return plane;
  const double side = words[1] == '<' ? -1 : 1;
  plane.normal = {side * std::abs(plane.normal.x), side * std::abs(plane.normal.y),
                  side * std::abs(plane.normal.z)};
  return plane;
}

draw::CutPlane plane_of_numbers(const std::string& words) {
  std::array<double, 4> numbers{};
  std::string_view rest = words;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t end = i < 3 ? rest.find(',') : rest.size();
    const auto value = end == std::string_view::npos ? std::nullopt : number_of(rest.substr(0, end));
    if (!value) refuse_cut(words);
    numbers[i] = *value;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  const auto& [x, y, z, d] = numbers;
  const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (largest == 0) refuse_cut(words);
  // The foot of the origin on the plane, from a normal of about length 1, whose square cannot overflow.
  const Vec3 n{x / largest, y / largest, z / largest};
  return {Point3{} + (d / largest / dot(n, n)) * n, n};
}

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

void parse_cut(const std::string& words, const draw::Box3& box, draw::TetPictureOptions& options) {
  if (words.empty()) return;
  if (words == "none") {
    options.cut = draw::CutStyle::none;
  } else if (words[0] >= 'x' && words[0] <= 'z') {
    options.cut_plane = plane_across(words, box, options.view);
  } else {
    options.cut_plane = plane_of_numbers(words);
  }
}

void draw_tets(const TetDrawing& drawing, const TetMesh& mesh) {
  if (!drawing.view.empty() && drawing.view.size() != 2) {
    throw InputError("--view", fmt::format("{} numbers for a mesh of space", drawing.view.size()),
                     "give azimuth,elevation in degrees");
  }
  draw::TetPictureOptions options;
  options.size = {drawing.size[0], drawing.size[1]};
  options.title = drawing.title;
  if (!drawing.view.empty())
    options.view.azimuth_deg = drawing.view[0], options.view.elevation_deg = drawing.view[1];
  options.view.field_of_view_deg = drawing.perspective_deg;
  if (drawing.section) options.cut = draw::CutStyle::planar;
  parse_cut(drawing.cut, draw::box_of(mesh), options);

  if (!drawing.field.empty()) return draw_field(drawing, mesh, options);
  if (drawing.what == "partition") {
    const auto parts = graph::recursive_spectral_bisection(graph::dual_graph(mesh), drawing.parts, drawing.seed);
    return draw::draw_tet_partition(drawing.picture, mesh, parts.part_of, parts.parts, options);
  }
  if (drawing.what == "matrix") {
    throw InputError("--what matrix", "the mesh is of space", "matrices are drawn of meshes of the plane");
  }
  draw::draw_tet_mesh(drawing.picture, mesh, fill_of(drawing.what), options);
}

}  // namespace leonhard::app
