// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/canvas/levels.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace leonhard::draw {
namespace {

constexpr double bar_width = 1.15, bar_gap = 0.3, bar_tick_length = 0.3, bar_tick_gap = 0.3,
                 bar_label_gap = 0.7;  // text sizes
constexpr TextStyle bar_tick_style{.size = 0.88};
constexpr double most_labels = 11;

double size_of(const Range& range) { return std::max(std::abs(range.low), std::abs(range.high)); }

// Every how many-th level is labelled, the labelled ones being nice values themselves.
long long label_stride(double step, std::size_t levels) {
  const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  const bool two_and_half = std::abs(mantissa - 2.5) < 0.01, five = std::abs(mantissa - 5) < 0.01;
  for (const long long stride : {1, 2, 4, 5, 10, 20, 40, 50, 100, 200}) {
    if ((two_and_half || five) && (stride == 5 || stride == 50)) continue;
    if (!two_and_half && !five && (stride == 4 || stride == 40)) continue;
    if (static_cast<double>(levels) / static_cast<double>(stride) <= most_labels) return stride;
  }
  return 400;
}

void label_regularly(Bands& bands, double step) {
  const long long stride = label_stride(step, bands.levels.size());
  for (const double level : bands.levels)
    bands.is_major.push_back(std::llround(std::floor(level / step + 1e-6)) % stride == 0);
  const double between = step * static_cast<double>(stride);
  for (const double value : multiples(between, bands.range.low, bands.range.high)) {
    bands.labels.push_back({value, label_of(value, between, size_of(bands.range))});
  }
}

void label_given(Bands& bands) {
  double closest = bands.range.high - bands.range.low;
  for (std::size_t i = 1; i < bands.levels.size(); ++i) {
    closest = std::min(closest, bands.levels[i] - bands.levels[i - 1]);
  }
  // Three digits below the least distance tell any two levels apart.
  const double step = std::pow(10.0, std::floor(std::log10(closest)) - 1);
  const auto stride =
      static_cast<std::size_t>(std::ceil(static_cast<double>(bands.levels.size()) / most_labels));
  for (std::size_t i = 0; i < bands.levels.size(); ++i) {
    const bool major = i % stride == 0;
    bands.is_major.push_back(major);
    if (major)
      bands.labels.push_back({bands.levels[i], label_of(bands.levels[i], step, size_of(bands.range))});
  }
}

void place_levels(Bands& bands, const Range& data, const FieldOptions& options, LevelPlace place) {
  const double step = nice_step((bands.range.high - bands.range.low) / options.bands);
  const double shift = place == LevelPlace::between_nice_values ? 0.5 : 0;
  // Out to whole steps, unless the range was asked for.
  if (!options.value_range) {
    bands.range = {(std::floor(data.low / step - shift + 1e-9) + shift) * step,
                   (std::ceil(data.high / step - shift - 1e-9) + shift) * step};
  }
  const double edge = 1e-6 * step;
  for (const double level : multiples(step / 2, bands.range.low + edge, bands.range.high - edge)) {
    const bool odd = std::llround(level / (step / 2)) % 2 != 0;
    if (odd == (shift > 0)) bands.levels.push_back(level);
  }
  label_regularly(bands, step);
}

void colour_bands(Bands& bands, ColourMap map) {
  const double span = bands.range.high - bands.range.low;
  double low = bands.range.low;
  for (std::size_t i = 0; i <= bands.levels.size(); ++i) {
    const double high = i < bands.levels.size() ? bands.levels[i] : bands.range.high;
    bands.colours.push_back(colour_at(map, ((low + high) / 2 - bands.range.low) / span));
    low = high;
  }
}

}  // namespace

std::size_t Bands::index_of(double value) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(levels, value) - levels.begin());
}

Bands make_bands(const Range& data, const FieldOptions& options, LevelPlace place) {
  Bands bands;
  bands.range = options.value_range.value_or(data);
  const double size = size_of(bands.range);
  const double span = bands.range.high - bands.range.low;
  if (span <= 1e-12 * size) {
    // A constant: one colour, and on the bar the value itself. Rounding noise is not blown up to a picture.
    const double middle = bands.range.low + span / 2, half = size > 0 ? 0.05 * size : 1;
    bands.range = {middle - half, middle + half};
    bands.labels.push_back({middle, label_of(middle, size > 0 ? nice_step(size * 1e-4) : 1, size)});
  } else if (!options.levels.empty()) {
    std::ranges::copy_if(options.levels, std::back_inserter(bands.levels),
                         [&](double level) { return level > bands.range.low && level < bands.range.high; });
    label_given(bands);
  } else {
    place_levels(bands, data, options, place);
  }
  colour_bands(bands, options.colour_map);
  bands.open_below = data.low < bands.range.low - 1e-9 * span;
  bands.open_above = data.high > bands.range.high + 1e-9 * span;
  return bands;
}

double colour_bar_room(Canvas& canvas, const Bands& bands, const std::string& label) {
  double labels = 0;
  for (const Tick& tick : bands.labels)
    labels = std::max(labels, canvas.text_width(tick.label, bar_tick_style));
  const double text = label.empty() ? 0.0 : bar_label_gap + 0.73;
  return labels + (bar_gap + bar_width + bar_tick_length + bar_tick_gap + text + 0.6) * canvas.text_size();
}

void draw_colour_bar(Canvas& canvas, const Rect& bar, const Bands& bands, const std::string& label) {
  const double em = canvas.text_size();
  const Rect box{bar.left + bar_gap * em, bar.top, bar_width * em, bar.height};
  // Pointed ends say that values go on beyond the range.
  const double point = 1.0 * em;
  const double top = box.top + (bands.open_above ? point : 0),
               bottom = box.bottom() - (bands.open_below ? point : 0);
  const auto y_of = [&](double value) {
    return bottom - (value - bands.range.low) / (bands.range.high - bands.range.low) * (bottom - top);
  };
  const auto outline = [&] {
    canvas.move_to({box.left, top});
    if (bands.open_above) canvas.line_to({box.left + box.width / 2, box.top});
    canvas.line_to({box.right(), top});
    canvas.line_to({box.right(), bottom});
    if (bands.open_below) canvas.line_to({box.left + box.width / 2, box.bottom()});
    canvas.line_to({box.left, bottom});
    canvas.close_path();
  };
  // From below, each band over all that follow: no seams between them.
  outline();
  canvas.fill(bands.colours.back());
  for (std::size_t i = bands.levels.size(); i-- > 0;) {
    const double y = y_of(bands.levels[i]);
    canvas.rectangle({box.left, y, box.width, bottom - y});
    canvas.fill(bands.colours[i]);
  }
  if (bands.open_below) {
    canvas.move_to({box.left, bottom});
    canvas.line_to({box.right(), bottom});
    canvas.line_to({box.left + box.width / 2, box.bottom()});
    canvas.close_path();
    canvas.fill(bands.colours.front());
  }
  outline();
  canvas.stroke({ink, 1});

  double widest = 0;
  for (const Tick& tick : bands.labels) {
    const double y = y_of(tick.value);
    canvas.line({box.right(), y}, {box.right() + bar_tick_length * em, y}, {ink, 1});
    canvas.text({box.right() + (bar_tick_length + bar_tick_gap) * em, y}, tick.label, bar_tick_style);
    widest = std::max(widest, canvas.text_width(tick.label, bar_tick_style));
  }
  const double beside = box.right() + (bar_tick_length + bar_tick_gap + bar_label_gap) * em + widest;
  draw_upright_label(canvas, beside + 0.365 * em, box.top + box.height / 2, label);
}

}  // namespace leonhard::draw
