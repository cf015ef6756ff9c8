// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "leonhard/kernel/point.hpp"

namespace leonhard::draw {

/// The size of a picture. Text and line widths grow with the picture, so that it looks alike at every size.
///
/// PNG has width x height pixels; SVG is that many CSS pixels; PDF takes 200 pixels to the inch (1600 px: 8 inches).
struct PictureSize {
  int width = 1600;   ///< pixels, 64 to 8192
  int height = 1000;  ///< pixels, 64 to 8192
  double scale = 1;   ///< further factor on text and line widths, 0.2 to 5
};

/// A rectangle of the mesh's plane, low < high in both directions.
struct Box {
  Point2 low{}, high{};
  friend bool operator==(const Box&, const Box&) = default;
};

/// What of the mesh is shown. Both directions have one scale, so that the picture may show more than the region
/// on two sides, never less. Without a region: the whole mesh.
struct View {
  std::optional<Box> region{};
};

/// Bounds of values, low < high.
struct Range {
  double low{}, high{};
  friend bool operator==(const Range&, const Range&) = default;
};

/// Where a legend stands. `automatic`: the corner that hides least.
enum class LegendPlace { automatic, top_right, top_left, bottom_right, bottom_left, none };

}  // namespace leonhard::draw
