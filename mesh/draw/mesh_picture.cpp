// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/mesh_picture.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "leonhard/mesh/draw/canvas/levels.hpp"
#include "leonhard/mesh/draw/canvas/line_writer.hpp"
#include "leonhard/mesh/draw/plane/scene.hpp"
#include "leonhard/mesh/quality.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

constexpr const char* quality_label = "smallest angle of the triangle (degrees)";

// Twelve bands of 5 degrees up to the equilateral triangle's 60.
Bands quality_bands() {
  FieldOptions options;
  options.value_range = Range{0, 60};
  options.bands = 12;
  return make_bands({0, 60}, options);
}

double smallest_angle_deg(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.corners[t];
  return mesh::triangle_quality(mesh.points[a], mesh.points[b], mesh.points[c]).min_angle_deg;
}

std::string boundary_name(const TriangleMesh& mesh, Marker marker) {
  const auto name = mesh.marker_names.find(marker);
  return name != mesh.marker_names.end() && !name->second.empty() ? name->second
                                                                  : "marker " + std::to_string(marker);
}

class MeshPicture {
 public:
  MeshPicture(Canvas& canvas, const TriangleMesh& mesh, const MeshOptions& options)
      : canvas_(canvas),
        mesh_(mesh),
        options_(options),
        text_{options.title, options.x_label, options.y_label} {}

  void draw() {
    const Box region = region_of(mesh_, options_.view);
    const bool with_bar = options_.fill == MeshFill::quality;
    const Bands bands = quality_bands();
    const double room = with_bar ? colour_bar_room(canvas_, bands, quality_label) - canvas_.text_size() : 0;
    const PlotFrame frame = fit_map(canvas_, {0, 0, canvas_.width() - room, canvas_.height()}, region, text_);
    const MeshScene scene(mesh_, frame);

    fill_bodies(canvas_, scene);
    if (with_bar) {
      fill_triangles(canvas_, scene, bands.colours,
                     [&](TriangleId t) { return bands.index_of(smallest_angle_deg(mesh_, t)); });
    }
    if (options_.fill == MeshFill::region) fill_regions(scene);
    const bool filled = options_.fill != MeshFill::none;
    stroke_edges(canvas_, scene, filled ? Colour{0.25, 0.25, 0.28} : Colour{0.22, 0.27, 0.36},
                 filled ? 0.6 : 0.9, options_.cell_of);
    if (options_.show_vertices) mark_vertices(scene);
    colour_boundaries(scene);
    ring_marks(scene);
    draw_axes(canvas_, frame, text_);
    draw_legend(canvas_, frame.area, legend_, options_.legend, scene.page());
    if (with_bar) {
      draw_colour_bar(
          canvas_, {frame.area.right() + 0.5 * canvas_.text_size(), frame.area.top, room, frame.area.height},
          bands, quality_label);
    }
  }

 private:
  void fill_regions(const MeshScene& scene) {
    std::map<double, std::size_t> number;
    const auto region = [&](TriangleId t) { return mesh_.regions.contains(t) ? mesh_.regions[t] : 0.0; };
    for (const TriangleId t : mesh_.corners.ids()) number.emplace(region(t), 0);
    std::vector<Colour> colours;
    for (auto& [attribute, index] : number) {
      // Past the palette's 65,000 entries regions share the last one's colour.
      index = std::min<std::size_t>(colours.size(), 65000);
      if (index == colours.size()) colours.push_back(area_colour(index));
      legend_.push_back(
          {.words = "region " + mesh::words(attribute), .colour = colours[index], .area = true});
    }
    fill_triangles(canvas_, scene, colours, [&](TriangleId t) { return number.at(region(t)); });
  }

  void mark_vertices(const MeshScene& scene) {
    std::set<VertexId> seen;
    for (const TriangleId t : scene.visible()) seen.insert(mesh_.corners[t].begin(), mesh_.corners[t].end());
    canvas_.begin_clip(scene.frame().area);
    const Rect safe = scene.safe();
    for (const VertexId v : seen) {
      const Point2 p = scene.page(v);
      if (p.x < safe.left || p.x > safe.right() || p.y < safe.top || p.y > safe.bottom()) continue;
      canvas_.circle(p, 1.9 * canvas_.thin());
      canvas_.fill(ink);
    }
    canvas_.end_clip();
  }

  void ring_marks(const MeshScene& scene) {
    canvas_.begin_clip(scene.frame().area);
    const Rect safe = scene.safe();
    for (const Point2 mark : options_.marks) {
      const Point2 p = scene.frame().page(mark);
      if (p.x < safe.left || p.x > safe.right() || p.y < safe.top || p.y > safe.bottom()) continue;
      canvas_.circle(p, 0.5 * canvas_.text_size());
      canvas_.stroke({{0.8, 0.1, 0.1}, 2.2});
    }
    canvas_.end_clip();
  }

  void colour_boundaries(const MeshScene& scene) {
    std::map<Marker, Colour> colour_of;
    std::set<Marker> shown;
    for (const MarkedEdge& edge : mesh_.boundary) {
      colour_of.emplace(edge.marker, ink);
      if (clip_segment(scene.page(edge.from), scene.page(edge.to), scene.frame().area))
        shown.insert(edge.marker);
    }
    if (options_.colour_boundaries) {
      std::size_t next = 0;
      for (auto& [marker, colour] : colour_of) {
        colour = line_colour(next++);
        if (!shown.contains(marker)) continue;
        legend_.push_back({.words = boundary_name(mesh_, marker), .colour = colour, .width = 2.6});
      }
    }
    stroke_boundary(canvas_, scene, 2.4, [&](Marker marker) { return colour_of.at(marker); });
  }

  Canvas& canvas_;
  const TriangleMesh& mesh_;
  const MeshOptions& options_;
  AxesText text_;
  std::vector<LegendEntry> legend_;
};

}  // namespace

void draw_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, const MeshOptions& options) {
  check_mesh(mesh);
  Canvas canvas(path, options.size);
  MeshPicture(canvas, mesh, options).draw();
  canvas.save();
}

}  // namespace leonhard::draw
