// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/diagram.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/canvas/levels.hpp"
#include "leonhard/mesh/draw/canvas/line_writer.hpp"
#include "leonhard/mesh/draw/plane/scene.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

constexpr double dot_radius = 2.6, title_size = 1.15;
constexpr std::size_t most_vectors = 60'000;  // shapes; beyond that an embedded image makes the smaller file

void include(std::optional<Box>& box, Point2 p) {
  if (!is_finite(p))
    throw InputError("diagram", "a point at " + mesh::words(p) + " cannot be drawn",
                     "give finite coordinates");
  if (!box) box = Box{p, p};
  box->low = {std::min(box->low.x, p.x), std::min(box->low.y, p.y)};
  box->high = {std::max(box->high.x, p.x), std::max(box->high.y, p.y)};
}

/// All shapes but the circles, with a little air.
Box box_of(const Diagram& diagram) {
  std::optional<Box> box;
  for (const auto& area : diagram.areas)
    for (const Point2 p : area.corners) include(box, p);
  for (const auto& path : diagram.paths)
    for (const Point2 p : path.points) include(box, p);
  for (const auto& dot : diagram.dots) include(box, dot.at);
  if (!box) throw InputError("diagram", "there is nothing to draw", "give a shape");
  double air = 0.05 * std::max(box->high.x - box->low.x, box->high.y - box->low.y);
  if (air == 0) air = 1;
  return {{box->low.x - air, box->low.y - air}, {box->high.x + air, box->high.y + air}};
}

Box region_of(const Diagram& diagram) {
  if (!diagram.region) return box_of(diagram);
  const auto& [low, high] = *diagram.region;
  if (!is_finite(low) || !is_finite(high) || !(low.x < high.x) || !(low.y < high.y))
    throw InputError("region", "from " + mesh::words(low) + " to " + mesh::words(high) + " is no region",
                     "give two finite corners, the lower left one first");
  return *diagram.region;
}

/// A frame without axes: as much of the rectangle as the title leaves.
PlotFrame plain_frame(const Canvas& canvas, Rect outer, const Box& region, bool has_title) {
  outer = outer.grown(-0.5 * canvas.text_size());
  const double top = has_title ? 1.9 * canvas.text_size() : 0;
  const Rect area{outer.left, outer.top + top, outer.width, outer.height - top};
  const Point2 centre = region.low + 0.5 * (region.high - region.low);
  const double unit =
      std::max((region.high.x - region.low.x) / area.width, (region.high.y - region.low.y) / area.height);
  const Vec2 half{unit * area.width / 2, unit * area.height / 2};
  return {area, {centre.x - half.x, centre.x + half.x}, {centre.y - half.y, centre.y + half.y}};
}

/// Bands for the areas' values; without values none.
std::optional<Bands> bands_of(const Diagram& diagram) {
  std::optional<Range> range;
  for (const auto& area : diagram.areas) {
    if (!area.value) continue;
    if (!range) range = Range{*area.value, *area.value};
    range = Range{std::min(range->low, *area.value), std::max(range->high, *area.value)};
  }
  if (!range) return std::nullopt;
  FieldOptions options;
  options.bands = 12;
  return make_bands(*range, options);
}

class DiagramPicture {
 public:
  DiagramPicture(Canvas& canvas, const Diagram& diagram, const Rect& outer)
      : canvas_(canvas), diagram_(diagram), bands_(bands_of(diagram)) {
    const Box region = region_of(diagram);
    Rect room = outer;
    if (bands_) room.width -= bar_room();
    frame_ = diagram.axes ? fit_map(canvas, room, region, {diagram.title, "x", "y"})
                          : plain_frame(canvas, room, region, !diagram.title.empty());
  }

  void draw() {
    const bool as_image = diagram_.areas.size() + diagram_.paths.size() + diagram_.dots.size() > most_vectors;
    if (as_image) canvas_.begin_raster(frame_.area);
    canvas_.begin_clip(frame_.area);
    for (const auto& area : diagram_.areas) fill(area);
    for (const auto& path : diagram_.paths) stroke(path.points, path.closed, path.stroke);
    for (const auto& circle : diagram_.circles) stroke(circle);
    for (const auto& dot : diagram_.dots) mark(dot);
    canvas_.end_clip();
    if (as_image) canvas_.end_raster();
    for (const auto& words : diagram_.words) write(words);
    finish();
  }

 private:
  [[nodiscard]] double bar_room() const {
    return colour_bar_room(canvas_, *bands_, diagram_.scale_label) - canvas_.text_size();
  }
  [[nodiscard]] Rect safe() const { return frame_.area.grown(100); }

  [[nodiscard]] std::vector<Point2> on_page(std::span<const Point2> points) const {
    std::vector<Point2> page;
    page.reserve(points.size());
    for (const Point2 p : points) page.push_back(frame_.page(p));
    return page;
  }

  void fill(const Diagram::Area& area) {
    add_polygon(canvas_, cut_polygon(on_page(area.corners), safe()));
    canvas_.fill(area.value && bands_ ? bands_->colours[bands_->index_of(*area.value)] : area.colour);
  }

  void stroke(std::span<const Point2> points, bool closed, const Stroke& how) {
    const std::vector<Point2> page = on_page(points);
    LineWriter writer(canvas_, safe());
    for (std::size_t i = 0; i + 1 < page.size(); ++i) writer.segment(page[i], page[i + 1]);
    if (closed && page.size() > 2) writer.segment(page.back(), page.front());
    canvas_.stroke({how.colour, how.width, how.style});
  }

  /// As a polygon, whose sides can be cut to the page however large the circle is.
  void stroke(const Diagram::Circle& circle) {
    constexpr int sides = 720;
    std::vector<Point2> points;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      points.push_back(circle.centre + circle.radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    stroke(points, true, circle.stroke);
  }

  void mark(const Diagram::Dot& dot) {
    const Point2 p = frame_.page(dot.at);
    const Rect room = safe();
    if (p.x < room.left || p.x > room.right() || p.y < room.top || p.y > room.bottom()) return;
    canvas_.circle(p, dot_radius * dot.size * canvas_.thin());
    canvas_.fill(dot.colour);
  }

  void write(const Diagram::Words& words) {
    const Point2 p = frame_.page(words.at);
    const double em = canvas_.text_size();
    const Point2 anchor{p.x + words.shift.x * em, p.y - words.shift.y * em};
    const TextStyle style{.across = words.across, .colour = words.colour};
    if (words.on_white) {
      const double width = canvas_.text_width(words.words, style);
      canvas_.rectangle(
          Rect{anchor.x - words.across * width, anchor.y - 0.5 * em, width, em}.grown(0.12 * em));
      canvas_.fill(white);
    }
    canvas_.text(anchor, words.words, style);
  }

  /// The title in the middle above the frame, smaller where it would not fit.
  void write_title() {
    TextStyle style{.size = title_size, .bold = true, .across = 0.5};
    style.size *= std::min(1.0, frame_.area.width / canvas_.text_width(diagram_.title, style));
    const double x = frame_.area.left + frame_.area.width / 2;
    canvas_.text({x, frame_.area.top - 0.9 * canvas_.text_size()}, diagram_.title, style);
  }

  void finish() {
    if (diagram_.axes) {
      draw_axes(canvas_, frame_, {diagram_.title, "x", "y"});
    } else if (!diagram_.title.empty()) {
      write_title();
    }
    if (!bands_) return;
    draw_colour_bar(
        canvas_,
        {frame_.area.right() + 0.5 * canvas_.text_size(), frame_.area.top, bar_room(), frame_.area.height},
        *bands_, diagram_.scale_label);
  }

  Canvas& canvas_;
  const Diagram& diagram_;
  std::optional<Bands> bands_;
  PlotFrame frame_;
};

}  // namespace

void Diagram::add_segment(Point2 a, Point2 b, const Stroke& stroke) { paths.push_back({{a, b}, stroke}); }

void Diagram::add_arrow(Point2 a, Point2 b, const Stroke& stroke) {
  add_segment(a, b, stroke);
  const Vec2 back = 0.12 * (a - b), side{-0.4 * back.y, 0.4 * back.x};
  paths.push_back({{b + (back + side), b, b + (back - side)}, {stroke.colour, stroke.width}});
}

void Diagram::add_mesh(const TriangleMesh& mesh, const Stroke& stroke) {
  for (const TriangleId t : mesh.corners.ids())
    for (unsigned i = 0; i < 3; ++i) {
      const MaybeId<TriangleId> behind = mesh.neighbours[t][i];
      if (behind && *behind < t) continue;
      add_segment(mesh.points[mesh.corners[t][(i + 1) % 3]], mesh.points[mesh.corners[t][(i + 2) % 3]],
                  stroke);
    }
}

void Diagram::add_named_dot(Point2 at, const std::string& name, Vec2 shift, Colour colour) {
  dots.push_back({at, colour});
  words.push_back({at, name, shift, colour});
}

void draw_diagram(const std::filesystem::path& path, const Diagram& diagram, const PictureSize& size) {
  draw_diagrams(path, std::span(&diagram, 1), 1, {}, size);
}

void draw_diagrams(const std::filesystem::path& path, std::span<const Diagram> panels, int columns,
                   const std::string& title, const PictureSize& size) {
  if (panels.empty() || columns < 1)
    throw InputError("diagrams", "there is nothing to draw", "give at least one panel and one column");
  Canvas canvas(path, size);
  const double top = title.empty() ? 0 : 2.4 * canvas.text_size();
  const auto across = static_cast<std::size_t>(columns);
  const std::size_t rows = (panels.size() + across - 1) / across;
  const double width = canvas.width() / static_cast<double>(across);
  const double height = (canvas.height() - top) / static_cast<double>(rows);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Rect outer{static_cast<double>(i % across) * width, top + static_cast<double>(i / across) * height,
                     width, height};
    DiagramPicture(canvas, panels[i], outer).draw();
  }
  if (!title.empty())
    canvas.text({canvas.width() / 2, top / 2}, title, {.size = title_size, .bold = true, .across = 0.5});
  canvas.save();
}

}  // namespace leonhard::draw
