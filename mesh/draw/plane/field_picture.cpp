// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/canvas/index_raster.hpp"
#include "leonhard/mesh/draw/canvas/levels.hpp"
#include "leonhard/mesh/draw/canvas/line_writer.hpp"
#include "leonhard/mesh/draw/mesh_picture.hpp"
#include "leonhard/mesh/draw/plane/contours.hpp"
#include "leonhard/mesh/draw/plane/field_layout.hpp"
#include "leonhard/mesh/draw/plane/scene.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

void check_values(const TriangleMesh& mesh, std::span<const double> values, const std::string& name) {
  if (values.size() != mesh.vertex_count()) {
    throw InputError(
        name, std::to_string(values.size()) + " values for " + std::to_string(mesh.vertex_count()) + " vertices",
        "give one value a vertex");
  }
  for (const VertexId v : mesh.points.ids()) {
    if (!std::isfinite(values[v.index()])) {
      throw InputError(name, "the value at " + mesh::words(mesh, v) + " is " + mesh::words(values[v.index()]),
                       "give finite values");
    }
  }
}

void check_levels(const std::string& name, const std::vector<double>& levels) {
  if (levels.size() > 1000) throw InputError(name, "there are more than 1000", "give fewer");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (!std::isfinite(levels[i]) || (i > 0 && !(levels[i - 1] < levels[i]))) {
      throw InputError(name, "level " + std::to_string(i) + " is " + mesh::words(levels[i]),
                       "give finite levels, each above the last");
    }
  }
}

void check_field(const TriangleMesh& mesh, std::span<const double> values, const FieldOptions& options) {
  check_mesh(mesh);
  check_values(mesh, values, "field '" + options.value_label + "'");
  if (!options.lines_of.empty()) check_values(mesh, options.lines_of, "field of the lines");
  if (options.value_range &&
      !(std::isfinite(options.value_range->low) && std::isfinite(options.value_range->high) &&
        options.value_range->low < options.value_range->high)) {
    throw InputError("value range",
                     "from " + mesh::words(options.value_range->low) + " to " +
                         mesh::words(options.value_range->high) + " is no range",
                     "give finite bounds, the lower one first");
  }
  if (options.bands < 1 || options.bands > 200) {
    throw InputError("bands", std::to_string(options.bands) + " is out of range", "give 1 to 200");
  }
  if (options.dashed_below && !std::isfinite(*options.dashed_below)) {
    throw InputError("dashed below", mesh::words(*options.dashed_below) + " is no value",
                     "give a finite value");
  }
  check_levels("levels", options.levels);
  check_levels("line levels", options.line_levels);
}

std::array<double, 3> values_at(const MeshScene& scene, std::span<const double> values, TriangleId t) {
  const auto& [a, b, c] = scene.mesh().corners[t];
  return {values[a.index()], values[b.index()], values[c.index()]};
}

// The values that can be seen: of triangles that touch the frame.
Range seen(const MeshScene& scene, std::span<const double> values) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const TriangleId t : scene.visible()) {
    const auto [low, high] = std::ranges::minmax(values_at(scene, values, t));
    range = {std::min(range.low, low), std::max(range.high, high)};
  }
  return range.low <= range.high ? range : Range{0, 0};
}

// Is much of the picture a plateau on a level, as a free stream of Mach 2 is? Its contour would show rounding noise.
bool has_plateau_on_level(const MeshScene& scene, std::span<const double> values, const Bands& bands) {
  if (bands.levels.size() < 2) return false;
  const double near = 0.1 * (bands.levels[1] - bands.levels[0]);
  double all = 0, on_level = 0;
  for (const TriangleId t : scene.visible()) {
    const auto p = scene.corners(t);
    const auto u = values_at(scene, values, t);
    const double area = std::abs(cross(p[1] - p[0], p[2] - p[0])), mean = (u[0] + u[1] + u[2]) / 3;
    const auto above = std::ranges::lower_bound(bands.levels, mean - near);
    all += area;
    if (above != bands.levels.end() && *above <= mean + near) on_level += area;
  }
  return on_level > 0.4 * all;  // a field without plateaus has a fifth of its area there
}

Bands bands_in_view(const MeshScene& scene, std::span<const double> values, const FieldOptions& options) {
  const Range range = seen(scene, values);
  Bands bands = make_bands(range, options);
  if (options.levels.empty() && has_plateau_on_level(scene, values, bands)) {
    bands = make_bands(range, options, LevelPlace::between_nice_values);
  }
  return bands;
}

void fill_bands_as_image(Canvas& canvas, const MeshScene& scene, std::span<const double> values,
                         const Bands& bands) {
  const Rect& area = scene.frame().area;
  IndexRaster raster(area, canvas.dots_per_pixel());
  for (const TriangleId t : scene.visible())
    raster.fill(scene.corners(t), values_at(scene, values, t), bands.levels);
  canvas.image(area, raster.resolve(bands.colours));
}

// One path a band. Its thin outline in its own colour closes the hair's breadth that viewers leave between areas.
void fill_bands_as_paths(Canvas& canvas, const MeshScene& scene, std::span<const double> values,
                         const Bands& bands) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::vector<std::vector<Point2>>> pieces(bands.colours.size());
  for (const TriangleId t : scene.visible()) {
    const auto u = values_at(scene, values, t);
    const auto [least, most] = std::ranges::minmax(u);
    for (std::size_t i = bands.index_of(least); i <= bands.index_of(most); ++i) {
      const double low = i == 0 ? -infinity : bands.levels[i - 1];
      const double high = i == bands.levels.size() ? infinity : bands.levels[i];
      const bool whole = least >= low && most <= high;
      const auto corners = scene.corners(t);
      pieces[i].push_back(cut_polygon(
          whole ? std::vector<Point2>(corners.begin(), corners.end()) : band_of(corners, u, low, high),
          scene.safe()));
    }
  }
  canvas.begin_clip(scene.frame().area);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const auto& polygon : pieces[i]) add_polygon(canvas, polygon);
    canvas.fill_and_keep(bands.colours[i]);
    canvas.stroke({bands.colours[i], 0.4});
  }
  canvas.end_clip();
}

void stroke_contours(Canvas& canvas, const MeshScene& scene, std::span<const double> values,
                     const Bands& bands, std::optional<double> dashed_below) {
  canvas.begin_clip(scene.frame().area);
  LineWriter writer(canvas, scene.safe());
  for (std::size_t i = 0; i < bands.levels.size(); ++i) {
    const Pen pen{{0.08, 0.08, 0.12},
                  bands.is_major[i] ? 0.95 : 0.55,
                  dashed_below && bands.levels[i] < *dashed_below ? LineStyle::dashed : LineStyle::solid,
                  bands.is_major[i] ? 0.75 : 0.6};
    for (const auto& line : contour(scene, values, bands.levels[i])) {
      for (std::size_t k = 1; k < line.size(); ++k) writer.segment(line[k - 1], line[k]);
      canvas.stroke(pen);
      writer.restart();
    }
  }
  canvas.end_clip();
}

}  // namespace

FieldLayout lay_out_field(Canvas& canvas, const TriangleMesh& mesh, std::span<const double> values,
                          const FieldOptions& options) {
  const Box region = region_of(mesh, options.view);
  const AxesText text{options.title, options.x_label, options.y_label};
  const double em = canvas.text_size();
  double room = em;
  for (int round = 0;; ++round) {
    const PlotFrame frame =
        fit_map(canvas, {0, 0, canvas.width() - room + em, canvas.height()}, region, text);
    Bands bands = bands_in_view(MeshScene(mesh, frame), values, options);
    const double needed = colour_bar_room(canvas, bands, options.value_label);
    if (needed <= room || round == 3) {
      return {
          frame, {frame.area.right() + 0.5 * em, frame.area.top, room, frame.area.height}, std::move(bands)};
    }
    room = needed;
  }
}

void draw_field(const std::filesystem::path& path, const TriangleMesh& mesh,
                std::span<const double> vertex_values, const FieldOptions& options) {
  check_field(mesh, vertex_values, options);
  Canvas canvas(path, options.size);
  const auto [frame, bar, bands] = lay_out_field(canvas, mesh, vertex_values, options);
  const MeshScene scene(mesh, frame);

  fill_bodies(canvas, scene);
  if (canvas.is_vector() && !scene.is_large_for_areas()) {
    fill_bands_as_paths(canvas, scene, vertex_values, bands);
  } else {
    fill_bands_as_image(canvas, scene, vertex_values, bands);
  }
  if (options.show_mesh) stroke_edges(canvas, scene, {0.2, 0.2, 0.25}, 0.5);
  if (!options.lines_of.empty()) {
    Bands lines;
    lines.levels = options.line_levels;
    lines.is_major.assign(lines.levels.size(), true);
    stroke_contours(canvas, scene, options.lines_of, lines, options.dashed_below);
  } else if (options.contour_lines) {
    stroke_contours(canvas, scene, vertex_values, bands, options.dashed_below);
  }
  stroke_boundary(canvas, scene, 1.8, [](Marker) { return ink; });
  draw_axes(canvas, frame, {options.title, options.x_label, options.y_label});
  draw_colour_bar(canvas, bar, bands, options.value_label);
  canvas.save();
}

}  // namespace leonhard::draw
