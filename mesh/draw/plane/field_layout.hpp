// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "leonhard/mesh/draw/canvas/levels.hpp"
#include "leonhard/mesh/draw/plane/scene.hpp"

namespace leonhard::draw {

/// Where the parts of a field's picture stand, and its colours.
struct FieldLayout {
  PlotFrame frame;
  Rect bar;  ///< the room of the colour bar, its ticks and label
  Bands bands;
};

/// The frame's width depends on the colour bar's labels, these on the values in view, that on the frame: the room
/// for the bar grows until it is enough.
[[nodiscard]] FieldLayout lay_out_field(Canvas& canvas, const TriangleMesh& mesh,
                                        std::span<const double> values, const FieldOptions& options);

}  // namespace leonhard::draw
