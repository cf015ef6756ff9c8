// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/canvas/axes.hpp"
#include "leonhard/mesh/draw/canvas/line_writer.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::draw {
namespace {

bool drawable(double value, bool logarithmic) { return std::isfinite(value) && (!logarithmic || value > 0); }

bool drawable(const AxesOptions& axes, Point2 p) {
  return drawable(p.x, axes.log_x) && drawable(p.y, axes.log_y);
}

void check_range(const std::optional<Range>& range, bool logarithmic, const std::string& where) {
  if (!range) return;
  if (!std::isfinite(range->low) || !std::isfinite(range->high) || !(range->low < range->high)) {
    throw InputError(where,
                     "from " + mesh::words(range->low) + " to " + mesh::words(range->high) + " is no range",
                     "give finite bounds, the lower one first");
  }
  if (logarithmic && !(range->low > 0)) {
    throw InputError(where, "a logarithmic axis cannot start at " + mesh::words(range->low),
                     "give a positive bound");
  }
}

void check_panel(const CurvePanel& panel) {
  check_range(panel.axes.x_range, panel.axes.log_x, "x range");
  check_range(panel.axes.y_range, panel.axes.log_y, "y range");
  bool any = false;
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    if (curve.x.size() != curve.y.size()) {
      throw InputError("curve " + std::to_string(c) + " '" + curve.name + "'",
                       "it has " + std::to_string(curve.x.size()) + " x and " +
                           std::to_string(curve.y.size()) + " y values",
                       "give one y for each x");
    }
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      any = any || drawable(panel.axes, {curve.x[i], curve.y[i]});
  }
  if (!any) {
    throw InputError(
        "curves '" + panel.axes.title + "'",
        "there is no point to draw: no values, or none finite (and positive on a logarithmic axis)",
        "give at least one");
  }
}

// Bounds of the data, widened so that curves keep off the frame and a constant has a height.
Axis axis_of(Range data, bool logarithmic, double air, const std::optional<Range>& wanted) {
  if (wanted) return {wanted->low, wanted->high, logarithmic};
  if (logarithmic) {
    const double factor = std::max(std::pow(data.high / data.low, air), data.high > data.low ? 1.0 : 2.0);
    return {data.low / factor, data.high * factor, true};
  }
  const double size = std::max(std::abs(data.low), std::abs(data.high));
  double margin = air * (data.high - data.low);
  if (data.high - data.low <= 1e-12 * size) margin = 0.05 * size;
  if (margin == 0) margin = 1;
  return {data.low - margin, data.high + margin, false};
}

std::pair<Axis, Axis> axes_of(const CurvePanel& panel) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range x{infinity, -infinity}, y{infinity, -infinity};
  const auto extend = [](Range& range, double v) {
    range = {std::min(range.low, v), std::max(range.high, v)};
  };
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const Point2 p{curve.x[i], curve.y[i]};
      if (!drawable(panel.axes, p)) continue;
      extend(x, p.x);
      // Only what will be seen counts for the height.
      if (!panel.axes.x_range || (p.x >= panel.axes.x_range->low && p.x <= panel.axes.x_range->high))
        extend(y, p.y);
    }
  }
  if (y.low > y.high) y = panel.axes.log_y ? Range{0.1, 1} : Range{0, 1};
  std::pair<Axis, Axis> axes{axis_of(x, panel.axes.log_x, 0.025, panel.axes.x_range),
                             axis_of(y, panel.axes.log_y, 0.06, panel.axes.y_range)};
  axes.second.reversed = panel.axes.invert_y;
  return axes;
}

AxesText text_of(const AxesOptions& axes) { return {axes.title, axes.x_label, axes.y_label}; }

// The curve's points on the page, broken into runs where a point cannot be drawn.
std::vector<std::vector<Point2>> runs_of(const Curve& curve, const AxesOptions& axes,
                                         const PlotFrame& frame) {
  std::vector<std::vector<Point2>> runs(1);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const Point2 p{curve.x[i], curve.y[i]};
    if (drawable(axes, p)) {
      runs.back().push_back(frame.page(p));
    } else if (!runs.back().empty()) {
      runs.emplace_back();
    }
  }
  return runs;
}

void draw_curve(Canvas& canvas, const Rect& area, const std::vector<std::vector<Point2>>& runs,
                const Curve& curve, Colour colour) {
  canvas.begin_clip(area.grown(canvas.thin()));
  LineWriter lines(canvas, area.grown(100));
  for (const auto& run : runs) {
    for (std::size_t i = 1; i < run.size(); ++i) lines.segment(run[i - 1], run[i]);
    // A lone point would be invisible without a marker.
    if (run.size() == 1) lines.segment(run[0], run[0]);
  }
  canvas.stroke({colour, 2.1, curve.line});
  canvas.end_clip();
  const Rect visible = area.grown(canvas.thin());
  for (const auto& run : runs) {
    for (const Point2 p : run) {
      const bool inside =
          p.x >= visible.left && p.x <= visible.right() && p.y >= visible.top && p.y <= visible.bottom();
      if (inside) draw_marker(canvas, curve.marker, p, colour);
    }
  }
}

// Where curves run, sampled closely enough for a legend to keep away from them.
void add_samples(std::vector<Point2>& samples, const std::vector<std::vector<Point2>>& runs, double spacing) {
  for (const auto& run : runs) {
    for (std::size_t i = 0; i < run.size(); ++i) {
      samples.push_back(run[i]);
      if (i == 0) continue;
      const double length = std::min(distance(run[i - 1], run[i]), 1e4);
      for (double s = spacing; s < length; s += spacing) {
        samples.push_back(run[i - 1] + (s / length) * (run[i] - run[i - 1]));
      }
    }
  }
}

void draw_panel(Canvas& canvas, const PlotFrame& frame, const CurvePanel& panel) {
  draw_grid(canvas, frame);
  std::vector<LegendEntry> legend;
  std::vector<Point2> samples;
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    const Colour colour = curve.colour.value_or(line_colour(c));
    const auto runs = runs_of(curve, panel.axes, frame);
    draw_curve(canvas, frame.area, runs, curve, colour);
    add_samples(samples, runs, canvas.text_size());
    if (!curve.name.empty()) legend.push_back({curve.name, colour, curve.line, curve.marker});
  }
  draw_axes(canvas, frame, text_of(panel.axes));
  // A curve alone is named by its axis.
  if (legend.size() == 1 && panel.axes.legend == LegendPlace::automatic) legend.clear();
  draw_legend(canvas, frame.area, legend, panel.axes.legend, samples);
}

}  // namespace

void draw_curves(const std::filesystem::path& path, std::span<const Curve> curves, const AxesOptions& axes,
                 const PictureSize& size) {
  const CurvePanel panel{{curves.begin(), curves.end()}, axes};
  draw_panels(path, std::span(&panel, 1), {}, 1, size);
}

void draw_panels(const std::filesystem::path& path, std::span<const CurvePanel> panels,
                 const std::string& title, int columns, const PictureSize& size) {
  if (panels.empty()) throw InputError("panels", "there is none", "give at least one");
  if (columns < 1) throw InputError("panels", std::to_string(columns) + " columns", "give at least 1");
  for (const CurvePanel& panel : panels) check_panel(panel);
  Canvas canvas(path, size);

  const auto count = static_cast<int>(panels.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  const double em = canvas.text_size(), top = title.empty() ? 0 : 2.4 * em;
  canvas.text({canvas.width() / 2, 0.7 * em}, title, {.size = 1.25, .bold = true, .across = 0.5, .down = 0});
  const double width = canvas.width() / columns, height = (canvas.height() - top) / rows;

  std::vector<std::pair<Axis, Axis>> axes;
  std::vector<double> left(static_cast<std::size_t>(columns));
  for (int i = 0; i < count; ++i) {
    axes.push_back(axes_of(panels[i]));
    left[i % columns] = std::max(
        left[i % columns], left_margin(canvas, axes[i].second, height - 5 * em, panels[i].axes.y_label));
  }
  for (int i = 0; i < count; ++i) {
    const Rect outer{i % columns * width, top + i / columns * height, width, height};
    const auto& [x, y] = axes[i];
    draw_panel(canvas, fit_frame(canvas, outer, x, y, text_of(panels[i].axes), left[i % columns]), panels[i]);
  }
  canvas.save();
}

void draw_histogram(const std::filesystem::path& path, std::span<const double> edges,
                    std::span<const double> counts, const AxesOptions& axes, const PictureSize& size) {
  if (counts.empty() || edges.size() != counts.size() + 1) {
    throw InputError(
        "histogram",
        std::to_string(edges.size()) + " bin edges do not fit " + std::to_string(counts.size()) + " counts",
        "give at least one count and one edge more than counts");
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!std::isfinite(edges[i]) || !std::isfinite(edges[i + 1]) || !(edges[i] < edges[i + 1])) {
      throw InputError("histogram",
                       "bin " + std::to_string(i) + " goes from " + mesh::words(edges[i]) + " to " +
                           mesh::words(edges[i + 1]),
                       "give finite edges that rise");
    }
    if (!std::isfinite(counts[i]) || counts[i] < 0) {
      throw InputError("histogram", "bin " + std::to_string(i) + " has the count " + mesh::words(counts[i]),
                       "give counts of 0 or more");
    }
  }
  check_range(axes.x_range, false, "x range");
  check_range(axes.y_range, false, "y range");
  Canvas canvas(path, size);
  const double highest = std::ranges::max(counts);
  const Axis x = axis_of({edges.front(), edges.back()}, false, 0.02, axes.x_range);
  const Axis y =
      axes.y_range ? Axis{axes.y_range->low, axes.y_range->high} : Axis{0, highest > 0 ? 1.08 * highest : 1};
  const PlotFrame frame = fit_frame(canvas, {0, 0, canvas.width(), canvas.height()}, x, y, text_of(axes));
  draw_grid(canvas, frame);
  canvas.begin_clip(frame.area);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Point2 low = frame.page({edges[i], 0}), high = frame.page({edges[i + 1], counts[i]});
    const double gap = std::min(canvas.thin(), 0.1 * (high.x - low.x));
    canvas.rectangle({low.x + gap, high.y, high.x - low.x - 2 * gap, low.y - high.y});
  }
  canvas.fill(line_colour(0));
  canvas.end_clip();
  draw_axes(canvas, frame, text_of(axes));
  canvas.save();
}

}  // namespace leonhard::draw
