// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/plane/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/canvas/index_raster.hpp"
#include "leonhard/mesh/draw/canvas/line_writer.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw InputError("mesh", problem, "run mesh::validate on it");
}

// The part of a polygon where side(p) >= 0, side being linear.
template <class Side>
std::vector<Point2> cut(const std::vector<Point2>& polygon, Side side) {
  std::vector<Point2> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double sa = side(a), sb = side(b);
    if (sa >= 0) result.push_back(a);
    if ((sa >= 0) != (sb >= 0)) result.push_back(a + (sa / (sa - sb)) * (b - a));
  }
  return result;
}

// The boundary edges end to end. Where loops touch in a vertex any continuation will do for a picture.
std::vector<std::vector<VertexId>> boundary_loops(const TriangleMesh& mesh) {
  std::multimap<VertexId, std::size_t> leaving;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) leaving.emplace(mesh.boundary[i].from, i);
  std::vector<std::vector<VertexId>> loops;
  while (!leaving.empty()) {
    std::vector<VertexId> loop;
    for (auto at = leaving.begin(); at != leaving.end();) {
      loop.push_back(at->first);
      const VertexId next = mesh.boundary[at->second].to;
      leaving.erase(at);
      at = leaving.find(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

double signed_area2(const TriangleMesh& mesh, const std::vector<VertexId>& loop) {
  const Point2 origin = mesh.points[loop[0]];
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += cross(mesh.points[loop[i]] - origin, mesh.points[loop[(i + 1) % loop.size()]] - origin);
  }
  return sum;
}

bool touches(const std::array<Point2, 3>& p, const Rect& r) {
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  return right >= r.left && left <= r.right() && bottom >= r.top && top <= r.bottom();
}

}  // namespace

std::vector<Point2> cut_polygon(std::vector<Point2> polygon, const Rect& r) {
  const bool inside = std::ranges::all_of(polygon, [&](Point2 p) {
    return p.x >= r.left && p.x <= r.right() && p.y >= r.top && p.y <= r.bottom();
  });
  if (inside) return polygon;
  polygon = cut(polygon, [&](Point2 p) { return p.x - r.left; });
  polygon = cut(polygon, [&](Point2 p) { return r.right() - p.x; });
  polygon = cut(polygon, [&](Point2 p) { return p.y - r.top; });
  return cut(polygon, [&](Point2 p) { return r.bottom() - p.y; });
}

void add_polygon(Canvas& canvas, std::span<const Point2> polygon) {
  if (polygon.size() < 3) return;
  canvas.move_to(polygon[0]);
  for (const Point2 p : polygon.subspan(1)) canvas.line_to(p);
  canvas.close_path();
}

void check_mesh(const TriangleMesh& mesh) {
  if (mesh.corners.empty()) throw InputError("mesh", "it has no triangle", "there is nothing to draw");
  if (mesh.neighbours.size() != mesh.corners.size()) {
    throw InputError("mesh",
                     std::to_string(mesh.neighbours.size()) + " triples of neighbours do not fit " +
                         std::to_string(mesh.corners.size()) + " triangles",
                     "call mesh::build_neighbours first");
  }
  for (const TriangleId t : mesh.corners.ids()) {
    for (const VertexId v : mesh.corners[t]) {
      if (!mesh.points.contains(v)) {
        refuse("triangle " + std::to_string(t.raw) + " names vertex " + std::to_string(v.raw) +
               ", which is not there");
      }
      if (!is_finite(mesh.points[v])) refuse(mesh::words(mesh, v) + " is not finite");
    }
    for (const MaybeId<TriangleId> n : mesh.neighbours[t]) {
      if (n && !mesh.neighbours.contains(*n)) {
        refuse("triangle " + std::to_string(t.raw) + " has neighbour " + std::to_string((*n).raw) +
               ", which is not there");
      }
    }
  }
  for (const MarkedEdge& edge : mesh.boundary) {
    if (!mesh.points.contains(edge.from) || !mesh.points.contains(edge.to)) {
      refuse("boundary edge " + std::to_string(edge.from.raw) + "-" + std::to_string(edge.to.raw) +
             " names a vertex that is not there");
    }
  }
}

Box region_of(const TriangleMesh& mesh, const View& view) {
  if (view.region) {
    const auto& [low, high] = *view.region;
    if (!is_finite(low) || !is_finite(high) || !(low.x < high.x) || !(low.y < high.y)) {
      throw InputError("view", "from " + mesh::words(low) + " to " + mesh::words(high) + " is no region",
                       "give two finite corners, the lower left one first");
    }
    return *view.region;
  }
  Box box{mesh.points[VertexId::from(0)], mesh.points[VertexId::from(0)]};
  for (const auto& triangle : mesh.corners) {
    for (const VertexId v : triangle) {
      const Point2 p = mesh.points[v];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  const double air = 0.02 * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  return {{box.low.x - air, box.low.y - air}, {box.high.x + air, box.high.y + air}};
}

PlotFrame fit_map(Canvas& canvas, const Rect& outer, const Box& region, const AxesText& text) {
  const Point2 centre = region.low + 0.5 * (region.high - region.low);
  PlotFrame frame{outer, {region.low.x, region.high.x}, {region.low.y, region.high.y}};
  // The room for labels depends on the ticks, these on the height shown, that on the room: twice is enough.
  for (int round = 0; round < 3; ++round) {
    frame = fit_frame(canvas, outer, frame.x, frame.y, text);
    const double unit = std::max((region.high.x - region.low.x) / frame.area.width,
                                 (region.high.y - region.low.y) / frame.area.height);  // world a page pixel
    const Vec2 half{unit * frame.area.width / 2, unit * frame.area.height / 2};
    frame.x = {centre.x - half.x, centre.x + half.x};
    frame.y = {centre.y - half.y, centre.y + half.y};
  }
  return frame;
}

MeshScene::MeshScene(const TriangleMesh& mesh, const PlotFrame& frame)
    : mesh_(mesh), frame_(frame), page_(mesh.vertex_count()), is_visible_(mesh.triangle_count()) {
  for (const VertexId v : mesh.points.ids()) page_[v] = frame.page(mesh.points[v]);
  for (const TriangleId t : mesh.corners.ids()) {
    if (!touches(corners(t), frame.area)) continue;
    visible_.push_back(t);
    is_visible_[t] = 1;
  }
}

std::array<Point2, 3> MeshScene::corners(TriangleId t) const {
  const auto& [a, b, c] = mesh_.corners[t];
  return {page_[a], page_[b], page_[c]};
}

void fill_bodies(Canvas& canvas, const MeshScene& scene) {
  canvas.begin_clip(scene.frame().area);
  for (const auto& loop : boundary_loops(scene.mesh())) {
    if (signed_area2(scene.mesh(), loop) >= 0) continue;  // the mesh lies inside this one
    std::vector<Point2> polygon;
    for (const VertexId v : loop) polygon.push_back(scene.page(v));
    add_polygon(canvas, cut_polygon(polygon, scene.safe()));
    canvas.fill({0.9, 0.9, 0.9});
  }
  canvas.end_clip();
}

void fill_triangles(Canvas& canvas, const MeshScene& scene, std::span<const Colour> colours,
                    const std::function<std::size_t(TriangleId)>& index_of) {
  const Rect& area = scene.frame().area;
  if (!canvas.is_vector() || scene.is_large_for_areas()) {
    IndexRaster raster(area, canvas.dots_per_pixel());
    for (const TriangleId t : scene.visible()) {
      raster.fill(scene.corners(t), static_cast<std::uint16_t>(index_of(t)));
    }
    canvas.image(area, raster.resolve(colours));
    return;
  }
  std::vector<std::vector<TriangleId>> of_colour(colours.size());
  for (const TriangleId t : scene.visible()) of_colour[index_of(t)].push_back(t);
  canvas.begin_clip(area);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (of_colour[i].empty()) continue;
    for (const TriangleId t : of_colour[i]) {
      const auto p = scene.corners(t);
      add_polygon(canvas, cut_polygon({p.begin(), p.end()}, scene.safe()));
    }
    canvas.fill(colours[i]);
  }
  canvas.end_clip();
}

void stroke_edges(Canvas& canvas, const MeshScene& scene, Colour colour, double width,
                  std::span<const std::size_t> cell_of) {
  // Bins by length on the page, in thin lines; the shorter the edges, the thinner.
  struct Bin {
    double below, width;
  };
  static constexpr std::array<Bin, 6> bins{
      {{1.5, 0.12}, {3, 0.2}, {6, 0.32}, {12, 0.5}, {24, 0.75}, {1e300, 1}}};
  constexpr std::size_t batch = 400;  // cairo's time grows faster than the path
  const TriangleMesh& mesh = scene.mesh();
  if (!cell_of.empty() && cell_of.size() != mesh.triangle_count())
    throw InputError("cell_of",
                     "it has " + std::to_string(cell_of.size()) + " entries for " +
                         std::to_string(mesh.triangle_count()) + " triangles",
                     "give one cell a triangle, or none");
  const auto is_within_cell = [&](TriangleId a, TriangleId b) {
    return !cell_of.empty() && cell_of[a.index()] == cell_of[b.index()];
  };
  std::array<std::vector<std::array<Point2, 2>>, bins.size()> lines;
  for (const TriangleId t : scene.visible()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const MaybeId<TriangleId> across = mesh.neighbours[t][i];
      if (across && scene.is_visible(*across) && *across < t) continue;  // drawn from there
      if (across && is_within_cell(t, *across)) continue;
      const Point2 a = scene.page(mesh.corners[t][(i + 1) % 3]), b = scene.page(mesh.corners[t][(i + 2) % 3]);
      const double length = distance(a, b) / canvas.thin();
      const auto bin =
          std::ranges::find_if(bins, [&](const Bin& candidate) { return length < candidate.below; });
      lines[bin - bins.begin()].push_back({a, b});
    }
  }
  if (scene.is_large_for_lines()) canvas.begin_raster(scene.frame().area);
  canvas.begin_clip(scene.frame().area);
  LineWriter writer(canvas, scene.safe());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const Pen pen{colour, width * bins[i].width};
    for (const auto& [a, b] : lines[i]) {
      writer.segment(a, b);
      if (writer.count() < batch) continue;
      canvas.stroke(pen);
      writer.restart();
    }
    canvas.stroke(pen);
    writer.restart();
  }
  canvas.end_clip();
  canvas.end_raster();
}

void stroke_boundary(Canvas& canvas, const MeshScene& scene, double width,
                     const std::function<Colour(Marker)>& colour_of) {
  std::map<Marker, std::vector<const MarkedEdge*>> of_marker;
  for (const MarkedEdge& edge : scene.mesh().boundary) of_marker[edge.marker].push_back(&edge);
  // Boundaries on the frame itself shall show their whole width.
  canvas.begin_clip(scene.frame().area.grown(canvas.thin() * width / 2));
  LineWriter writer(canvas, scene.safe());
  for (const auto& [marker, edges] : of_marker) {
    for (const MarkedEdge* edge : edges) writer.segment(scene.page(edge->from), scene.page(edge->to));
    canvas.stroke({colour_of(marker), width});
    writer.restart();
  }
  canvas.end_clip();
}

}  // namespace leonhard::draw
