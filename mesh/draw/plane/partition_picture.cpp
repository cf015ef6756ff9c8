// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <set>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/canvas/index_raster.hpp"
#include "leonhard/mesh/draw/canvas/line_writer.hpp"
#include "leonhard/mesh/draw/canvas/part_colours.hpp"
#include "leonhard/mesh/draw/mesh_picture.hpp"
#include "leonhard/mesh/draw/plane/scene.hpp"

namespace leonhard::draw {
namespace {

using Part = std::uint32_t;

// A partition of triangles or of vertices, on a page.
struct PartScene {
  const MeshScene& scene;
  std::span<const Part> part_of;
  bool of_triangles;

  [[nodiscard]] Part at(TriangleId t) const { return part_of[t.index()]; }
  [[nodiscard]] Part at(VertexId v) const { return part_of[v.index()]; }
};

void check_parts(const TriangleMesh& mesh, std::span<const Part> part_of, Part parts) {
  check_mesh(mesh);
  if (part_of.size() != mesh.triangle_count() && part_of.size() != mesh.vertex_count()) {
    throw InputError("partition",
                     std::to_string(part_of.size()) + " entries fit neither " +
                         std::to_string(mesh.triangle_count()) + " triangles nor " +
                         std::to_string(mesh.vertex_count()) + " vertices",
                     "give one part a triangle or one a vertex");
  }
  if (parts < 1 || parts > 65000) {
    throw InputError("partition", std::to_string(parts) + " parts are out of range", "give 1 to 65000");
  }
  for (std::size_t i = 0; i < part_of.size(); ++i) {
    if (part_of[i] >= parts) {
      throw InputError("partition",
                       "entry " + std::to_string(i) + " is part " + std::to_string(part_of[i]) + " of " +
                           std::to_string(parts),
                       "number the parts from 0");
    }
  }
}

// Which parts touch, over the whole mesh, so that a close-up keeps the colours of the whole.
std::vector<std::set<Part>> touching_parts(const TriangleMesh& mesh, std::span<const Part> part_of,
                                           bool of_triangles, Part parts) {
  std::vector<std::set<Part>> touching(parts);
  const auto touch = [&](Part a, Part b) {
    if (a == b) return;
    touching[a].insert(b);
    touching[b].insert(a);
  };
  for (const TriangleId t : mesh.corners.ids()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto across = mesh.neighbours[t][i];
      if (of_triangles && across) touch(part_of[t.index()], part_of[(*across).index()]);
      if (!of_triangles) {
        touch(part_of[mesh.corners[t][i].index()], part_of[mesh.corners[t][(i + 1) % 3].index()]);
      }
    }
  }
  return touching;
}

Point2 middle(Point2 a, Point2 b) { return a + 0.5 * (b - a); }

Point2 centroid(const std::array<Point2, 3>& p) { return p[0] + (1.0 / 3) * ((p[1] - p[0]) + (p[2] - p[0])); }

// A vertex's share of a triangle of the median dual: the quadrilateral to the edges' middles and the centroid.
std::array<Point2, 4> share(const std::array<Point2, 3>& p, std::size_t i) {
  return {p[i], middle(p[i], p[(i + 1) % 3]), centroid(p), middle(p[i], p[(i + 2) % 3])};
}

void fill_shares(Canvas& canvas, const PartScene& parts, std::span<const Colour> colours,
                 std::span<const std::size_t> colour_of) {
  const MeshScene& scene = parts.scene;
  const Rect& area = scene.frame().area;
  const bool as_image = !canvas.is_vector() || scene.is_large_for_areas();
  IndexRaster raster(as_image ? area : Rect{0, 0, 1, 1}, canvas.dots_per_pixel());
  std::vector<std::vector<std::array<Point2, 4>>> of_colour(colours.size());
  for (const TriangleId t : scene.visible()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t colour = colour_of[parts.at(scene.mesh().corners[t][i])];
      const auto q = share(scene.corners(t), i);
      if (as_image) {
        raster.fill({q[0], q[1], q[2]}, static_cast<std::uint16_t>(colour));
        raster.fill({q[0], q[2], q[3]}, static_cast<std::uint16_t>(colour));
      } else {
        of_colour[colour].push_back(q);
      }
    }
  }
  if (as_image) return canvas.image(area, raster.resolve(colours));
  canvas.begin_clip(area);
  for (std::size_t c = 0; c < colours.size(); ++c) {
    for (const auto& q : of_colour[c]) add_polygon(canvas, cut_polygon({q.begin(), q.end()}, scene.safe()));
    canvas.fill(colours[c]);
  }
  canvas.end_clip();
}

// The borders between parts: mesh edges, or pieces of median-dual faces.
void stroke_borders(Canvas& canvas, const PartScene& parts, double width) {
  const MeshScene& scene = parts.scene;
  canvas.begin_clip(scene.frame().area);
  LineWriter writer(canvas, scene.safe());
  for (const TriangleId t : scene.visible()) {
    const auto p = scene.corners(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if (parts.of_triangles) {
        const auto across = scene.mesh().neighbours[t][i];
        if (across && parts.at(*across) != parts.at(t)) writer.segment(p[j], p[k]);
      } else if (parts.at(scene.mesh().corners[t][j]) != parts.at(scene.mesh().corners[t][k])) {
        writer.segment(middle(p[j], p[k]), centroid(p));
      }
    }
  }
  canvas.stroke({ink, width});
  canvas.end_clip();
}

}  // namespace

void draw_partition(const std::filesystem::path& path, const TriangleMesh& mesh,
                    std::span<const std::uint32_t> part_of, std::uint32_t parts,
                    const PartitionOptions& options) {
  check_parts(mesh, part_of, parts);
  const Box region = region_of(mesh, options.view);
  Canvas canvas(path, options.size);
  const AxesText text{options.title, options.x_label, options.y_label};
  const PlotFrame frame = fit_map(canvas, {0, 0, canvas.width(), canvas.height()}, region, text);
  const MeshScene scene(mesh, frame);
  const PartScene part_scene{scene, part_of, part_of.size() == mesh.triangle_count()};

  const auto colour_of = colour_parts(touching_parts(mesh, part_of, part_scene.of_triangles, parts));
  std::vector<Colour> palette;
  for (std::size_t c = 0; c <= std::ranges::max(colour_of); ++c) palette.push_back(area_colour(c));

  fill_bodies(canvas, scene);
  if (part_scene.of_triangles) {
    fill_triangles(canvas, scene, palette, [&](TriangleId t) { return colour_of[part_scene.at(t)]; });
  } else {
    fill_shares(canvas, part_scene, palette, colour_of);
  }
  if (options.show_mesh) stroke_edges(canvas, scene, {0.45, 0.45, 0.5}, 0.5, options.cell_of);
  stroke_borders(canvas, part_scene, 1.5);
  stroke_boundary(canvas, scene, 1.6, [](Marker) { return ink; });
  draw_axes(canvas, frame, text);
  canvas.save();
}

}  // namespace leonhard::draw
