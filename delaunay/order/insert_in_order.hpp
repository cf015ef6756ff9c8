// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "leonhard/delaunay/order/insertion_order.hpp"
#include "leonhard/delaunay/point_triangulation.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// What an incremental algorithm made, and how much of it was only for a time.
struct [[nodiscard]] Construction {
  PointTriangulation result;
  /// Triangles ever made, ghost triangles among them, the first one and its ghosts not counted.
  std::size_t structural_changes = 0;
};

/// Poll the stop request and report every `poll` points; false once work is to stop.
[[nodiscard]] inline bool go_on(const Progress& progress, std::size_t done, std::size_t all) {
  constexpr std::size_t poll = 4096;
  if (done % poll != 0) return true;
  progress("triangulate", static_cast<double>(done) / static_cast<double>(all));
  return !progress.stop_requested();
}

/// The frame of the incremental algorithms on triangles: the first triangle that three points of the order
/// span, with its ghosts, then one point after another.
///
/// points    distinct and finite
/// order     a permutation of the points; three that span a triangle come first (bring_triangle_to_front)
/// inserter  inserter.start(triangulation) is called once, inserter.insert(triangulation, vertex) for each
///           next point; each insert returns the number of triangles made
template <class Inserter>
Construction insert_in_order(std::span<const Point2> points, std::vector<std::uint32_t> order,
                             const Progress& progress, Inserter&& inserter) {
  using Outcome = TriangulateOutcome;
  if (points.size() < 3) return {{Outcome::too_few_points, {}}};
  if (!bring_triangle_to_front(points, order)) return {{Outcome::all_collinear, {}}};
  Construction made;
  GhostTriangulation& in = made.result.triangulation;
  in.reserve(2 * points.size() + 4);
  in.start(VertexId{order[0]}, VertexId{order[1]}, VertexId{order[2]});
  inserter.start(in);
  for (std::size_t k = 3; k < order.size(); ++k) {
    if (!go_on(progress, k, order.size())) return {{Outcome::stopped, {}}};
    made.structural_changes += inserter.insert(in, VertexId{order[k]});
  }
  return made;
}

}  // namespace leonhard::delaunay
