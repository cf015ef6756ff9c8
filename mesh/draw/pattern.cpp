// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/canvas/axes.hpp"

namespace leonhard::draw {
namespace {

std::size_t rows_of(const MatrixPattern& pattern) { return pattern.offsets.size() - 1; }

void check_pattern(const MatrixPattern& pattern) {
  const std::string where = "matrix pattern '" + pattern.title + "'";
  if (pattern.offsets.size() < 2) throw InputError(where, "it has no rows", "give one offset more than rows");
  if (pattern.offsets.front() != 0 || pattern.offsets.back() != pattern.links.size()) {
    throw InputError(where,
                     "offsets go from " + std::to_string(pattern.offsets.front()) + " to " +
                         std::to_string(pattern.offsets.back()) + " for " +
                         std::to_string(pattern.links.size()) + " links",
                     "they start at 0 and end at the number of links");
  }
  for (std::size_t row = 0; row < rows_of(pattern); ++row) {
    if (pattern.offsets[row] > pattern.offsets[row + 1]) {
      throw InputError(where, "the offsets fall after row " + std::to_string(row),
                       "give offsets that never fall");
    }
    for (std::size_t k = pattern.offsets[row]; k < pattern.offsets[row + 1]; ++k) {
      if (pattern.links[k] >= rows_of(pattern)) {
        throw InputError(where,
                         "row " + std::to_string(row) + " has column " + std::to_string(pattern.links[k]) +
                             " of " + std::to_string(rows_of(pattern)),
                         "number columns from 0");
      }
    }
  }
}

// new_of_old, checked: each row once.
std::vector<std::uint32_t> inverse_order(const MatrixPattern& pattern) {
  const std::size_t rows = rows_of(pattern);
  const std::string where = "order of the matrix pattern '" + pattern.title + "'";
  if (!pattern.order.empty() && pattern.order.size() != rows) {
    throw InputError(where,
                     std::to_string(pattern.order.size()) + " entries for " + std::to_string(rows) + " rows",
                     "give each row once");
  }
  constexpr auto unset = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> inverse(rows, unset);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t old = pattern.order.empty() ? i : pattern.order[i];
    if (old >= rows || inverse[old] != unset) {
      throw InputError(where,
                       "entry " + std::to_string(i) + " is " + std::to_string(old) +
                           (old < rows ? ", which came before" : ", which is no row"),
                       "give each row once");
    }
    inverse[old] = static_cast<std::uint32_t>(i);
  }
  return inverse;
}

template <class Visit>
void each_entry(const MatrixPattern& pattern, const std::vector<std::uint32_t>& new_of_old, Visit visit) {
  for (std::size_t row = 0; row < rows_of(pattern); ++row) {
    if (pattern.add_diagonal) visit(new_of_old[row], new_of_old[row]);
    for (std::size_t k = pattern.offsets[row]; k < pattern.offsets[row + 1]; ++k) {
      visit(new_of_old[row], new_of_old[pattern.links[k]]);
    }
  }
}

// Entries as squares where each has two pixels or more.
void draw_squares(Canvas& canvas, const Rect& area, const MatrixPattern& pattern,
                  const std::vector<std::uint32_t>& new_of_old) {
  const double cell = area.width / static_cast<double>(rows_of(pattern)), gap = cell > 6 ? 0.08 * cell : 0;
  each_entry(pattern, new_of_old, [&](std::uint32_t row, std::uint32_t column) {
    canvas.rectangle(
        {area.left + column * cell + gap, area.top + row * cell + gap, cell - 2 * gap, cell - 2 * gap});
  });
  canvas.fill(line_colour(0));
}

// Entries counted in each pixel; one alone is already well visible.
void draw_density(Canvas& canvas, const Rect& area, const MatrixPattern& pattern,
                  const std::vector<std::uint32_t>& new_of_old) {
  const int pixels = std::max(1, static_cast<int>(std::lround(area.width)));
  const double scale = pixels / static_cast<double>(rows_of(pattern));
  const auto pixel_of = [&](std::uint32_t index) {
    return std::min(static_cast<std::size_t>((index + 0.5) * scale), static_cast<std::size_t>(pixels - 1));
  };
  std::vector<std::uint32_t> count(std::size_t(pixels) * pixels);
  each_entry(pattern, new_of_old, [&](std::uint32_t row, std::uint32_t column) {
    ++count[pixel_of(row) * pixels + pixel_of(column)];
  });
  const LabColour paper = to_lab(white), full = to_lab(line_colour(0));
  std::vector<std::uint32_t> shade(256);
  for (std::size_t i = 0; i < shade.size(); ++i) {
    const double s = static_cast<double>(i) / 255;
    shade[i] = packed(to_srgb({paper.lightness + s * (full.lightness * 0.6 - paper.lightness),
                               paper.a + s * (full.a - paper.a), paper.b + s * (full.b - paper.b)}));
  }
  Raster raster{pixels, pixels, std::vector<std::uint32_t>(count.size())};
  for (std::size_t i = 0; i < count.size(); ++i) {
    const double darkness = count[i] == 0 ? 0 : 1 - 0.4 * std::exp(-0.35 * (count[i] - 1.0));
    raster.pixels[i] = shade[static_cast<std::size_t>(std::lround(255 * darkness))];
  }
  canvas.image(area, raster);
}

// A square frame in the middle of its share of the page.
PlotFrame square_frame(Canvas& canvas, const Rect& outer, const MatrixPattern& pattern) {
  const double rows = static_cast<double>(rows_of(pattern));
  const Axis across{0, rows}, down{.low = 0, .high = rows, .reversed = true};
  PlotFrame frame = fit_frame(canvas, outer, across, down, {pattern.title, pattern.subtitle, {}});
  Rect& area = frame.area;
  const double side = std::floor(std::min(area.width, area.height));
  area = {std::round(area.left + (area.width - side) / 2), std::round(area.top + (area.height - side) / 2),
          side, side};
  return frame;
}

void draw_one(Canvas& canvas, const PlotFrame& frame, const MatrixPattern& pattern,
              const std::vector<std::uint32_t>& new_of_old) {
  if (frame.area.width >= 2 * static_cast<double>(rows_of(pattern))) {
    draw_squares(canvas, frame.area, pattern, new_of_old);
  } else {
    draw_density(canvas, frame.area, pattern, new_of_old);
  }
  draw_axes(canvas, frame, {pattern.title, pattern.subtitle, {}});
}

}  // namespace

void draw_pattern(const std::filesystem::path& path, std::span<const MatrixPattern> patterns,
                  const std::string& title, const PictureSize& size) {
  if (patterns.empty()) throw InputError("matrix patterns", "there is none", "give at least one");
  std::vector<std::vector<std::uint32_t>> inverses;
  for (const MatrixPattern& pattern : patterns) {
    check_pattern(pattern);
    inverses.push_back(inverse_order(pattern));
  }
  Canvas canvas(path, size);
  const double em = canvas.text_size(), top = title.empty() ? 0 : 2.8 * em;
  const double width = canvas.width() / static_cast<double>(patterns.size());
  double highest = canvas.height();
  std::vector<PlotFrame> frames;
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const Rect outer{static_cast<double>(i) * width, top, width, canvas.height() - top};
    frames.push_back(square_frame(canvas, outer, patterns[i]));
    highest = std::min(highest, frames.back().area.top);
  }
  canvas.text({canvas.width() / 2, highest - 4.0 * em}, title,
              {.size = 1.25, .bold = true, .across = 0.5, .down = 0});
  for (std::size_t i = 0; i < patterns.size(); ++i) draw_one(canvas, frames[i], patterns[i], inverses[i]);
  canvas.save();
}

}  // namespace leonhard::draw
