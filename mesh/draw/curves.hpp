// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/draw/colour.hpp"
#include "leonhard/mesh/draw/line_style.hpp"
#include "leonhard/mesh/draw/picture.hpp"

/// Curves and histograms. Format, errors and determinism as in mesh_picture.hpp.
namespace leonhard::draw {

/// One curve. A point that is not finite, or not positive on a logarithmic axis, interrupts the line: the history
/// of a run that diverged can be drawn.
struct Curve {
  std::string name{};  ///< in the legend; empty: not there
  std::vector<double> x{}, y{};
  LineStyle line = LineStyle::solid;
  MarkerStyle marker = MarkerStyle::none;
  std::optional<Colour> colour{};  ///< default: the next of line_colour
};

struct AxesOptions {
  std::string title{}, x_label{}, y_label{};
  bool invert_y = false;  ///< low values at the top, as is the custom for a pressure coefficient
  bool log_x = false, log_y = false;
  std::optional<Range> x_range{}, y_range{};        ///< default: the data with a little air
  LegendPlace legend = LegendPlace::automatic;  ///< automatic: none for a curve alone
};

/// Curves on one pair of axes.
void draw_curves(const std::filesystem::path& path, std::span<const Curve> curves, const AxesOptions& axes,
                 const PictureSize& size = {});

struct CurvePanel {
  std::vector<Curve> curves{};
  AxesOptions axes{};
};

/// Several pairs of axes in one picture, row by row, `columns` in a row: a convergence history with the residual
/// above the coefficients, say.
void draw_panels(const std::filesystem::path& path, std::span<const CurvePanel> panels,
                 const std::string& title, int columns = 1, const PictureSize& size = {});

/// A histogram.
///
/// edges   counts.size() + 1 strictly rising bounds of the bins
/// counts  one non-negative count a bin
void draw_histogram(const std::filesystem::path& path, std::span<const double> edges,
                    std::span<const double> counts, const AxesOptions& axes, const PictureSize& size = {});

}  // namespace leonhard::draw
