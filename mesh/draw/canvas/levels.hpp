// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "leonhard/mesh/draw/canvas/axes.hpp"
#include "leonhard/mesh/draw/field_options.hpp"

namespace leonhard::draw {

/// How values become colours: bands between levels.
struct Bands {
  Range range;                  ///< the ends of the colour bar
  std::vector<double> levels;   ///< rising, strictly inside the range
  std::vector<bool> is_major;   ///< one a level: labelled on the bar, its contour line thicker
  std::vector<Colour> colours;  ///< levels + 1: below the first level, between, from the last on
  std::vector<Tick> labels;
  bool open_below = false, open_above = false;  ///< values lie beyond the range

  [[nodiscard]] std::size_t index_of(double value) const;
};

/// Where levels that are not given stand: on nice values, or half-way between them, which makes these the middles
/// of the bands.
enum class LevelPlace { on_nice_values, between_nice_values };

/// Bands for values that span `data`, in the range and with the number of bands or the levels that are asked for.
[[nodiscard]] Bands make_bands(const Range& data, const FieldOptions& options,
                               LevelPlace place = LevelPlace::on_nice_values);

/// A colour bar in a rectangle of the page, with ticks and a label to its right.
void draw_colour_bar(Canvas& canvas, const Rect& bar, const Bands& bands, const std::string& label);

/// The room that colour bar, ticks and label need, gaps included.
[[nodiscard]] double colour_bar_room(Canvas& canvas, const Bands& bands, const std::string& label);

}  // namespace leonhard::draw
