// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/canvas/part_colours.hpp"

#include <algorithm>

namespace leonhard::draw {

std::vector<std::size_t> colour_parts(const std::vector<std::set<std::uint32_t>>& touching) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::uint32_t> order(touching.size());
  for (std::uint32_t p = 0; p < order.size(); ++p) order[p] = p;
  std::ranges::stable_sort(
      order, [&](std::uint32_t p, std::uint32_t q) { return touching[p].size() > touching[q].size(); });
  std::vector<std::size_t> colour(touching.size(), none), used(std::min<std::size_t>(8, touching.size()), 0);
  for (const std::uint32_t p : order) {
    std::vector<bool> taken(used.size() + 1, false);
    for (const std::uint32_t q : touching[p]) {
      if (colour[q] != none) taken[colour[q]] = true;
    }
    std::size_t best = none;
    for (std::size_t c = 0; c < used.size(); ++c) {
      if (!taken[c] && (best == none || used[c] < used[best])) best = c;
    }
    if (best == none) {
      best = used.size();
      used.push_back(0);
    }
    colour[p] = best;
    ++used[best];
  }
  return colour;
}

}  // namespace leonhard::draw
