// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/canvas/axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace leonhard::draw {
namespace {

// Lengths in text sizes, which keep every picture's proportions.
constexpr double tick_length = 0.38, tick_gap = 0.32, label_gap = 0.62, outer_gap = 0.55;
constexpr double tick_text = 0.88, label_text = 1.0, title_text = 1.15;
constexpr double cap = 0.73;  // height of digits
constexpr Pen axis_pen{ink, 1.1};

const TextStyle tick_style{.size = tick_text};

std::string superscript(int exponent) {
  static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string result = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) result += digits[c - '0'];
  return result;
}

// A true minus sign, and no "-0".
std::string fixed(double value, int decimals) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, std::abs(value));
  const std::string digits = buffer.data();
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? "−" : "") + digits;
}

// Decimals after which a nice step has no digits left: 0.25 -> 2.
int decimals_of(double step) {
  for (int decimals = 0; decimals < 12; ++decimals) {
    const double scaled = step * std::pow(10.0, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled) return decimals;
  }
  return 12;
}

std::vector<Tick> log_ticks(const Axis& axis, int target) {
  const int first = static_cast<int>(std::floor(std::log10(axis.low) + 1e-12));
  const int last = static_cast<int>(std::ceil(std::log10(axis.high) - 1e-12));
  const int stride = std::max(1, static_cast<int>(std::ceil((last - first) / std::max(1.0, double(target)))));
  const bool few = last - first <= 2;  // label 2 and 5 as well
  std::vector<Tick> result;
  for (int decade = first; decade <= last; ++decade) {
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10.0, decade);
      if (value < axis.low * (1 - 1e-12) || value > axis.high * (1 + 1e-12)) continue;
      if (digit > 1 && stride > 1) continue;
      Tick tick{value, {}};
      if (digit == 1 && decade % stride == 0) tick.label = "10" + superscript(decade);
      if (few && (digit == 2 || digit == 5)) tick.label = std::to_string(digit) + "×10" + superscript(decade);
      result.push_back(tick);
    }
  }
  return result;
}

double widest(Canvas& canvas, std::span<const Tick> ticks) {
  double width = 0;
  for (const Tick& tick : ticks) width = std::max(width, canvas.text_width(tick.label, tick_style));
  return width;
}

double tick_size(const Canvas& canvas, const Tick& tick) {
  return (tick.label.empty() ? 0.55 : 1.0) * tick_length * canvas.text_size();
}

void draw_x_ticks(Canvas& canvas, const PlotFrame& frame) {
  const double em = canvas.text_size(), bottom = frame.area.bottom();
  for (const Tick& tick : ticks_of(frame.x, ticks_across(canvas, frame.area.width))) {
    const double x = frame.area.left + frame.x.fraction(tick.value) * frame.area.width;
    canvas.line({x, bottom}, {x, bottom + tick_size(canvas, tick)}, axis_pen);
    canvas.text({x, bottom + (tick_length + tick_gap) * em}, tick.label,
                {.size = tick_text, .across = 0.5, .down = 0});
  }
}

void draw_y_ticks(Canvas& canvas, const PlotFrame& frame) {
  const double em = canvas.text_size(), left = frame.area.left;
  for (const Tick& tick : ticks_of(frame.y, ticks_down(canvas, frame.area.height))) {
    const double y = frame.area.bottom() - frame.y.fraction(tick.value) * frame.area.height;
    canvas.line({left - tick_size(canvas, tick), y}, {left, y}, axis_pen);
    canvas.text({left - (tick_length + tick_gap) * em, y}, tick.label, {.size = tick_text, .across = 1});
  }
}

Rect legend_box(const Rect& area, double width, double height, double gap, LegendPlace place) {
  const bool left = place == LegendPlace::top_left || place == LegendPlace::bottom_left;
  const bool bottom = place == LegendPlace::bottom_left || place == LegendPlace::bottom_right;
  return {left ? area.left + gap : area.right() - gap - width,
          bottom ? area.bottom() - gap - height : area.top + gap, width, height};
}

LegendPlace emptiest_corner(const Rect& area, double width, double height, double gap,
                            std::span<const Point2> occupied) {
  LegendPlace best = LegendPlace::top_right;
  std::size_t fewest = occupied.size() + 1;
  for (const LegendPlace place :
       {LegendPlace::top_right, LegendPlace::top_left, LegendPlace::bottom_right, LegendPlace::bottom_left}) {
    const Rect box = legend_box(area, width, height, gap, place).grown(gap / 2);
    const auto hidden = static_cast<std::size_t>(std::ranges::count_if(occupied, [&](Point2 p) {
      return p.x > box.left && p.x < box.right() && p.y > box.top && p.y < box.bottom();
    }));
    if (hidden < fewest) {
      fewest = hidden;
      best = place;
    }
  }
  return best;
}

}  // namespace

double Axis::fraction(double v) const {
  const double f = logarithmic ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
  return reversed ? 1 - f : f;
}

double Axis::value(double f) const {
  if (reversed) f = 1 - f;
  return logarithmic ? low * std::pow(high / low, f) : low + f * (high - low);
}

Point2 PlotFrame::page(Point2 p) const {
  return {area.left + x.fraction(p.x) * area.width, area.bottom() - y.fraction(p.y) * area.height};
}

Point2 PlotFrame::world(Point2 p) const {
  return {x.value((p.x - area.left) / area.width), y.value((area.bottom() - p.y) / area.height)};
}

double nice_step(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double best = power;
  for (const double mantissa : {1.0, 2.0, 2.5, 5.0, 10.0}) {
    if (std::abs(std::log(mantissa * power / rough)) < std::abs(std::log(best / rough)))
      best = mantissa * power;
  }
  return best;
}

std::vector<double> multiples(double step, double low, double high) {
  // Below 1 the step is a whole number of tenths, hundredths, ...: dividing by those rounds once only.
  const double parts = step < 1 ? std::pow(10.0, decimals_of(step)) : 1;
  const double whole = parts > 1 && parts < 1e12 ? std::round(step * parts) : step * parts;
  std::vector<double> result;
  const auto first = std::llround(std::ceil(low / step - 1e-9));
  const auto last = std::llround(std::floor(high / step + 1e-9));
  for (auto k = first; k <= last; ++k) result.push_back(static_cast<double>(k) * whole / parts);
  return result;
}

std::string label_of(double value, double step, double largest) {
  const double size = std::max(std::abs(largest), step);
  if (size < 1e6 && (step >= 1e-4 || size >= 1e-2)) return fixed(value, decimals_of(step));
  if (std::abs(value) < step * 1e-6) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
  const double power = std::pow(10.0, exponent);
  return fixed(value / power, decimals_of(step / power)) + "×10" + superscript(exponent);
}

std::vector<Tick> ticks_of(const Axis& axis, int target) {
  if (axis.logarithmic) return log_ticks(axis, target);
  const double step = nice_step((axis.high - axis.low) / std::max(target, 1));
  std::vector<Tick> result;
  const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
  for (const double value : multiples(step, axis.low, axis.high)) {
    result.push_back({value, label_of(value, step, largest)});
  }
  return result;
}

int ticks_across(const Canvas& canvas, double length) {
  return std::clamp(static_cast<int>(length / (5.0 * canvas.text_size())), 2, 10);
}

int ticks_down(const Canvas& canvas, double length) {
  return std::clamp(static_cast<int>(length / (2.6 * canvas.text_size())), 2, 10);
}

double left_margin(Canvas& canvas, const Axis& y, double height, const std::string& label) {
  const double em = canvas.text_size();
  const double labels = widest(canvas, ticks_of(y, ticks_down(canvas, height)));
  return labels + (tick_length + tick_gap + outer_gap + (label.empty() ? 0.2 : label_gap + cap)) * em;
}

PlotFrame fit_frame(Canvas& canvas, const Rect& outer, const Axis& x, const Axis& y, const AxesText& text,
                    double left) {
  const double em = canvas.text_size();
  const double top = (text.title.empty() ? 0.9 : outer_gap + 2.0 * title_text) * em;
  const double bottom =
      (tick_length + tick_gap + cap * tick_text + outer_gap + (text.x_label.empty() ? 0 : label_gap + 1.0)) *
      em;
  const double last_label = widest(canvas, ticks_of(x, ticks_across(canvas, outer.width)));
  const double right = std::max(1.6 * em, last_label / 2 + 0.6 * em);
  Rect area{outer.left, outer.top + top, outer.width, std::max(outer.height - top - bottom, 4 * em)};
  const double margin = std::max(left, left_margin(canvas, y, area.height, text.y_label));
  area.left += margin;
  area.width = std::max(outer.width - margin - right, 4 * em);
  return {area, x, y, outer.left + (outer_gap + cap) * em};
}

void draw_grid(Canvas& canvas, const PlotFrame& frame) {
  const Pen pen{{0.88, 0.88, 0.88}, 0.8};
  for (const Tick& tick : ticks_of(frame.x, ticks_across(canvas, frame.area.width))) {
    const double x = frame.area.left + frame.x.fraction(tick.value) * frame.area.width;
    if (!tick.label.empty()) canvas.line({x, frame.area.top}, {x, frame.area.bottom()}, pen);
  }
  for (const Tick& tick : ticks_of(frame.y, ticks_down(canvas, frame.area.height))) {
    const double y = frame.area.bottom() - frame.y.fraction(tick.value) * frame.area.height;
    if (!tick.label.empty()) canvas.line({frame.area.left, y}, {frame.area.right(), y}, pen);
  }
}

void draw_axes(Canvas& canvas, const PlotFrame& frame, const AxesText& text) {
  const double em = canvas.text_size();
  const Rect& area = frame.area;
  canvas.rectangle(area);
  canvas.stroke(axis_pen);
  draw_x_ticks(canvas, frame);
  draw_y_ticks(canvas, frame);
  const double below = area.bottom() + (tick_length + tick_gap + cap * tick_text + label_gap) * em;
  canvas.text({area.left + area.width / 2, below}, text.x_label,
              {.size = label_text, .across = 0.5, .down = 0});
  draw_upright_label(canvas, frame.y_label_at - cap * em / 2, area.top + area.height / 2, text.y_label);
  canvas.text({area.left, area.top - 0.75 * em}, text.title, {.size = title_text, .bold = true, .down = 1});
}

void draw_upright_label(Canvas& canvas, double x, double y, const std::string& label) {
  const bool short_enough = canvas.text_width(label, {.size = label_text}) < 0.95 * canvas.text_size();
  canvas.text({x, y}, label, {.size = label_text, .across = 0.5, .upwards = !short_enough});
}

void draw_marker(Canvas& canvas, MarkerStyle marker, Point2 at, Colour colour) {
  const double r = 4.2 * canvas.thin();
  const auto polygon = [&](std::initializer_list<Vec2> corners) {
    bool first = true;
    for (const Vec2 v : corners) {
      first ? canvas.move_to(at + r * v) : canvas.line_to(at + r * v);
      first = false;
    }
    canvas.close_path();
  };
  switch (marker) {
    case MarkerStyle::none:
      return;
    case MarkerStyle::cross:
      canvas.line(at + r * Vec2{-0.9, -0.9}, at + r * Vec2{0.9, 0.9}, {colour, 1.5});
      canvas.line(at + r * Vec2{-0.9, 0.9}, at + r * Vec2{0.9, -0.9}, {colour, 1.5});
      return;
    case MarkerStyle::circle:
      canvas.circle(at, r);
      break;
    case MarkerStyle::square:
      polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
      break;
    case MarkerStyle::triangle:
      polygon({{-1.05, 0.75}, {1.05, 0.75}, {0, -1.1}});
      break;
    case MarkerStyle::diamond:
      polygon({{-1.2, 0}, {0, -1.2}, {1.2, 0}, {0, 1.2}});
      break;
  }
  canvas.fill_and_keep(white);
  canvas.stroke({colour, 1.5});
}

void draw_legend(Canvas& canvas, const Rect& area, std::span<const LegendEntry> entries, LegendPlace place,
                 std::span<const Point2> occupied) {
  if (entries.empty() || place == LegendPlace::none) return;
  constexpr std::size_t most = 24;
  const std::size_t shown = std::min(entries.size(), most);
  const std::string rest =
      entries.size() > most ? "and " + std::to_string(entries.size() - most) + " more" : "";
  const double em = canvas.text_size(), row = 1.45 * em, sample = 1.9 * em, pad = 0.6 * em;
  const TextStyle style{.size = 0.92};
  double words = canvas.text_width(rest, style);
  for (const LegendEntry& entry : entries.first(shown))
    words = std::max(words, canvas.text_width(entry.words, style));
  const double width = words + sample + 2.8 * pad;
  const double height = row * static_cast<double>(shown + (rest.empty() ? 0 : 1)) + pad;
  if (place == LegendPlace::automatic) place = emptiest_corner(area, width, height, 0.7 * em, occupied);

  const Rect box = legend_box(area, width, height, 0.7 * em, place);
  canvas.rectangle(box);
  canvas.fill(white, 0.92);
  canvas.rectangle(box);
  canvas.stroke({{0.72, 0.72, 0.72}, 0.8});
  double y = box.top + pad / 2 + row / 2;
  const double left = box.left + pad;
  for (const LegendEntry& entry : entries.first(shown)) {
    if (entry.area) {
      canvas.rectangle({left, y - 0.4 * em, sample, 0.8 * em});
      canvas.fill_and_keep(entry.colour);
      canvas.stroke({{0.45, 0.45, 0.45}, 0.7});
    } else {
      canvas.line({left, y}, {left + sample, y}, {entry.colour, entry.width, entry.line});
      draw_marker(canvas, entry.marker, {left + sample / 2, y}, entry.colour);
    }
    canvas.text({left + sample + 0.8 * pad, y}, entry.words, style);
    y += row;
  }
  canvas.text({left + sample + 0.8 * pad, y}, rest, style);
}

}  // namespace leonhard::draw
