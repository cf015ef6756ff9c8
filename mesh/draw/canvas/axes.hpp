// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/canvas/canvas.hpp"

/// Axes, ticks and legends, alike in every picture. Not meant for callers of the room.
namespace leonhard::draw {

struct Axis {
  double low = 0, high = 1;  ///< low < high; both positive if logarithmic
  bool logarithmic = false;
  bool reversed = false;  ///< high values at the left or the bottom

  /// 0 at the axis' start (left, bottom), 1 at its end.
  [[nodiscard]] double fraction(double value) const;
  [[nodiscard]] double value(double fraction) const;
};

struct Tick {
  double value{};
  std::string label;  ///< empty for a minor tick
};

/// A multiple of a power of ten by 1, 2, 2.5 or 5: of these the nearest to `rough` > 0 in ratio.
[[nodiscard]] double nice_step(double rough);

/// The multiples of `step` in [low, high], each the double nearest to its decimal as far as that is possible.
[[nodiscard]] std::vector<double> multiples(double step, double low, double high);

/// Labels with as many digits as a step between them needs: "0.25". Where the largest of the values labelled
/// together is 10^6 or more, or tiny, all have its power of ten: "2.5×10⁻⁵".
[[nodiscard]] std::string label_of(double value, double step, double largest);

/// Ticks at nice values, about `target` of them with labels; decades on a logarithmic axis.
[[nodiscard]] std::vector<Tick> ticks_of(const Axis& axis, int target);

struct AxesText {
  std::string title, x_label, y_label;
};

/// A rectangle of the page and the axes that map the world into it.
struct PlotFrame {
  Rect area;
  Axis x, y;
  double y_label_at = 0;  ///< page: the base line of the upright label on the left
  [[nodiscard]] Point2 page(Point2 world) const;
  [[nodiscard]] Point2 world(Point2 page) const;
};

/// How many ticks suit a length of page.
[[nodiscard]] int ticks_across(const Canvas& canvas, double length);
[[nodiscard]] int ticks_down(const Canvas& canvas, double length);

/// The room that the axis on the left needs: ticks, their labels, the axis' label.
[[nodiscard]] double left_margin(Canvas& canvas, const Axis& y, double height, const std::string& label);

/// The frame inside `outer` that leaves room for ticks, labels and title.
///
/// left  at least so much on the left, so that frames above one another line up
[[nodiscard]] PlotFrame fit_frame(Canvas& canvas, const Rect& outer, const Axis& x, const Axis& y,
                                  const AxesText& text, double left = 0);

/// Frame, ticks, labels and title; `grid` lines are faint.
void draw_axes(Canvas& canvas, const PlotFrame& frame, const AxesText& text);
void draw_grid(Canvas& canvas, const PlotFrame& frame);

struct LegendEntry {
  std::string words;
  Colour colour;
  LineStyle line = LineStyle::solid;
  MarkerStyle marker = MarkerStyle::none;
  bool area = false;  ///< a filled square in place of a line
  double width = 2;   ///< of the line
};

/// A label beside a vertical axis, its middle at (x, y): turned upwards unless it is one letter.
void draw_upright_label(Canvas& canvas, double x, double y, const std::string& label);

void draw_marker(Canvas& canvas, MarkerStyle marker, Point2 at, Colour colour);

/// A legend in a corner of `area`; `automatic` takes the corner with the fewest of `occupied` (page) under it.
/// At most 24 entries are shown, then "and 7 more".
void draw_legend(Canvas& canvas, const Rect& area, std::span<const LegendEntry> entries, LegendPlace place,
                 std::span<const Point2> occupied);

}  // namespace leonhard::draw
