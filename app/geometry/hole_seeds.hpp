// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/pslg.hpp"

namespace leonhard::app {

/// The points of each of a graph's closed outlines in order; none if a point has other than two segments or none.
[[nodiscard]] std::optional<std::vector<std::vector<std::size_t>>> closed_outlines(const Pslg& pslg);

/// Give a graph of closed outlines a seed for each hole: outlines within an odd number of others bound one, so that what is
/// filled and what is empty take turns from the outside in. The graph must have no holes yet. Where its segments are no separate
/// closed outlines nothing is done, which a warning tells if there could be a hole.
///
/// throws  InputError naming outline and place: an outline that crosses or touches itself or another one
/// Cost O(outlines · points).
void find_holes(Pslg& pslg, std::vector<std::string>& warnings);

}  // namespace leonhard::app
