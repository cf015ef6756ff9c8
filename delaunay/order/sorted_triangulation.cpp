// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/order/sorted_triangulation.hpp"

#include <optional>
#include <utility>

#include "leonhard/delaunay/plane/fast.hpp"

namespace leonhard::delaunay {

SortedTriangulation sort_and_triangulate(std::span<const Point2> points, Algorithm algorithm,
                                         const AlgorithmOptions& options) {
  SortedTriangulation result;
  if (algorithm == Algorithm::fast) {
    std::optional<CutOrder> order = sort_by_cuts(points, options.threads, options.progress);
    if (!order) return {{}, {TriangulateOutcome::stopped, {}}};
    result.cells = triangulate_fast(*order, options);
    result.sorted = std::move(order->sorted);
  } else {
    result.sorted = sort_and_merge(points);
    result.cells = triangulate_distinct(result.sorted.points, algorithm, options);
  }
  return result;
}

}  // namespace leonhard::delaunay
