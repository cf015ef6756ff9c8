// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

/// What tests of orders share.
namespace leonhard::testing {

inline bool is_permutation_of_indices(std::vector<std::uint32_t> order, std::size_t count) {
  std::ranges::sort(order);
  std::vector<std::uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0U);
  return order == indices;
}

/// The length of the tour through the points in the order given.
template <class Point>
double tour_length(const std::vector<Point>& points, const std::vector<std::uint32_t>& order) {
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i) length += distance(points[order[i]], points[order[i - 1]]);
  return length;
}

}  // namespace leonhard::testing
