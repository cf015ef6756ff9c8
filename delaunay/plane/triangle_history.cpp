// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/triangle_history.hpp"

#include <cassert>

#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

void TriangleHistory::reserve(std::size_t points) {
  nodes_.reserve(9 * points);
  node_of_.reserve(2 * points);
}

void TriangleHistory::start(const GhostTriangulation& in) {
  assert(nodes_.empty() && in.triangle_count() == 4);
  for (IdRaw t = 0; t < 4; ++t) add_node(in, AnyTriangleId{t});
}

void TriangleHistory::add_node(const GhostTriangulation& in, AnyTriangleId t) {
  if (!node_of_.contains(t)) node_of_.resize(t.index() + 1);
  node_of_[t] = nodes_.push_back({{in.corner(t, 0), in.corner(t, 1), in.corner(t, 2)}, t.raw, 0});
}

void TriangleHistory::replaced(const GhostTriangulation& in, std::span<const AnyTriangleId> olds,
                               std::span<const AnyTriangleId> news) {
  for (const AnyTriangleId t : olds) {
    Node& node = nodes_[node_of_[t]];
    node.first_child = HistoryNodeId::from(nodes_.size()).raw;
    node.child_count = static_cast<IdRaw>(news.size());
  }
  for (const AnyTriangleId t : news) add_node(in, t);
}

AnyTriangleId TriangleHistory::find(std::span<const Point2> points, Point2 p) const {
  HistoryNodeId n = holder(HistoryNodeId{0}, 4, points, p);
  while (nodes_[n].child_count > 0) n = holder(child(n, 0), nodes_[n].child_count, points, p);
  return AnyTriangleId{nodes_[n].first_child};
}

/// Of consecutive nodes, one of which holds p, one that does.
HistoryNodeId TriangleHistory::holder(HistoryNodeId first, std::size_t count, std::span<const Point2> points,
                                      Point2 p) const {
  const HistoryNodeId last = HistoryNodeId::from(first.index() + count - 1);
  HistoryNodeId n = first;
  while (n != last && !holds(n, points, p)) ++n.raw;
  assert(holds(n, points, p));
  return n;
}

bool TriangleHistory::holds(HistoryNodeId n, std::span<const Point2> points, Point2 p) const {
  const auto& [a, b, c] = nodes_[n].corners;
  const auto side = [&](VertexId from, VertexId to) {
    return kernel::orient2d(points[from.index()], points[to.index()], p);
  };
  if (a == GhostTriangulation::ghost)
    return side(b, c) == Sign::positive && left_of_ray(c, points, p) && !left_of_ray(b, points, p);
  return side(a, b) != Sign::negative && side(b, c) != Sign::negative && side(c, a) != Sign::negative;
}

bool TriangleHistory::left_of_ray(VertexId through, std::span<const Point2> points, Point2 p) const {
  for (const VertexId corner : nodes_[HistoryNodeId{0}].corners) {
    const Sign side = kernel::orient2d(points[corner.index()], points[through.index()], p);
    if (side != Sign::zero) return side == Sign::positive;
  }
  return false;
}

}  // namespace leonhard::delaunay
