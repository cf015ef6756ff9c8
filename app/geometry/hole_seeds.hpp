// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/mesh/pslg.hpp"

namespace leonhard::app {

/// The points of each of the closed outlines that segments make, in order; none if a point has other than two segments or none.
///
/// points  how many there are
[[nodiscard]] std::optional<std::vector<std::vector<std::size_t>>> closed_outlines(
    std::span<const Pslg::Segment> segments, std::size_t points);

/// Give a graph of closed outlines a seed for each hole: outlines within an odd number of others bound one, so that what is
/// filled and what is empty take turns from the outside in. The graph must have no holes yet. Where the segments are no separate
/// closed outlines nothing is done, which a warning tells.
///
/// outline_segments  that many, the first ones, are the outlines
///
/// throws  InputError naming outline and place: an outline that crosses or touches itself or another one
/// Cost O(outlines · points).
void find_holes(Pslg& pslg, std::size_t outline_segments, std::vector<std::string>& warnings);

}  // namespace leonhard::app
