// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "leonhard/delaunay/voronoi_clip.hpp"

namespace leonhard::delaunay {

/// Where edges of a diagram cross sides of windows, by the sides' names: each is found once, so that windows that share a side
/// share its points.
using WindowCrossings = std::map<std::pair<VoronoiEdgeId, std::size_t>, Point2>;

/// As clip, for one of several windows.
///
/// sides  the names of the window's sides in `crossings`, from each corner to the next; a side of two windows has one name
[[nodiscard]] ClippedVoronoi clip_to_window(const VoronoiDiagram& diagram, std::span<const Point2> window,
                                            std::span<const std::size_t> sides, WindowCrossings& crossings);

}  // namespace leonhard::delaunay
