// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/bowyer.hpp"

#include <cstdint>
#include <vector>

#include "leonhard/delaunay/order/insert_in_order.hpp"
#include "leonhard/delaunay/plane/bowyer_diagram.hpp"

namespace leonhard::delaunay {

PointTriangulation triangulate_bowyer(std::span<const Point2> points, const AlgorithmOptions& options) {
  using Outcome = TriangulateOutcome;
  if (points.size() < 3) return {Outcome::too_few_points, {}};
  std::vector<std::uint32_t> order = order_in_rounds(points.size());
  if (!bring_triangle_to_front(points, order)) return {Outcome::all_collinear, {}};
  BowyerDiagram diagram(points, VertexId{order[0]}, VertexId{order[1]}, VertexId{order[2]});
  for (std::size_t k = 3; k < order.size(); ++k) {
    if (!go_on(options.progress, k, order.size())) return {Outcome::stopped, {}};
    diagram.insert(VertexId{order[k]});
  }
  return {Outcome::done, diagram.triangulation()};
}

}  // namespace leonhard::delaunay
