// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/order/sorted_points.hpp"

#include "leonhard/kernel/hilbert.hpp"

namespace leonhard::delaunay {

SortedPoints sort_and_merge(std::span<const Point2> points) {
  const std::vector<std::uint32_t> order = kernel::hilbert_order(points);
  SortedPoints sorted;
  sorted.points.reserve(points.size());
  sorted.first_input.reserve(points.size());
  sorted.sorted_index.resize(points.size());
  for (const std::uint32_t i : order) {
    if (sorted.points.empty() || sorted.points.back() != points[i]) {
      sorted.points.push_back(points[i]);
      sorted.first_input.push_back(i);
    }
    sorted.sorted_index[i] = static_cast<std::uint32_t>(sorted.points.size() - 1);
  }
  return sorted;
}

}  // namespace leonhard::delaunay
