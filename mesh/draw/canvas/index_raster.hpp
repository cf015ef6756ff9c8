// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/mesh/draw/canvas/canvas.hpp"

namespace leonhard::draw {

/// Filled triangles as pixels: each sample (several a pixel) holds the index of a colour, and the samples of a
/// pixel are averaged at the end. Every sample belongs to exactly one of the triangles around it, so that
/// neither gaps nor seams show between neighbours.
class IndexRaster {
 public:
  /// area  of the page; dots  image pixels a page pixel
  IndexRaster(const Rect& area, double dots);

  /// The triangle abc (page, any orientation) in one colour; index < 65535.
  void fill(const std::array<Point2, 3>& corners, std::uint16_t index);

  /// The triangle with values at its corners, linear between: index i where i of the rising levels are at or
  /// below the value.
  void fill(const std::array<Point2, 3>& corners, const std::array<double, 3>& values,
            std::span<const double> levels);

  /// The picture, transparent where no triangle was filled.
  [[nodiscard]] Raster resolve(std::span<const Colour> colours) const;

 private:
  template <class Paint>
  void scan(const std::array<Point2, 3>& corners, Paint paint);

  int width_, height_, samples_;  ///< of the image; samples a pixel in each direction
  Point2 origin_;
  double per_page_;  ///< samples a page pixel
  std::vector<std::uint16_t> index_;
};

}  // namespace leonhard::draw
