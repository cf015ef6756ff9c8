// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/delaunay_tree.hpp"

#include <cassert>
#include <utility>

#include "leonhard/delaunay/order/insert_in_order.hpp"
#include "leonhard/delaunay/plane/swap_insertion.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {
namespace {

/// Green and Sibson's insertion that writes and reads the history.
class TreeInserter {
 public:
  TreeInserter(std::span<const Point2> points, TriangleHistory& history)
      : points_(points), history_(history) {}

  void start(const GhostTriangulation& in) {
    history_.reserve(points_.size());
    history_.start(in);
  }
  std::size_t insert(GhostTriangulation& in, VertexId v) {
    const Point2 p = points_[v.index()];
    const Location at = location_in(in, points_, history_.find(points_, p), p);
    return insertion_.insert(in, points_, v, at, history_);
  }

 private:
  std::span<const Point2> points_;
  TriangleHistory& history_;
  SwapInsertion insertion_;
};

}  // namespace

DelaunayTree::DelaunayTree(std::vector<Point2> points, std::vector<std::uint32_t> order,
                           const Progress& progress)
    : points_(std::move(points)), order_(std::move(order)) {
  build(progress);
}

DelaunayTree::DelaunayTree(std::vector<Point2> points, const AlgorithmOptions& options)
    : points_(std::move(points)), order_(random_order(points_.size(), options.seed)) {
  build(options.progress);
}

void DelaunayTree::build(const Progress& progress) {
  (void)bring_triangle_to_front(points_, order_);  // as insert_in_order will do: order() tells the truth
  Construction made = insert_in_order(points_, order_, progress, TreeInserter(points_, history_));
  outcome_ = made.result.outcome;
  triangulation_ = std::move(made.result.triangulation);
  structural_changes_ = made.structural_changes;
}

Location DelaunayTree::locate(Point2 p) const {
  assert(outcome_ == TriangulateOutcome::done);
  return location_in(triangulation_, points_, history_.find(points_, p), p);
}

VertexId DelaunayTree::nearest(Point2 p) const {
  const GhostTriangulation& in = triangulation_;
  const auto nearer = [&](VertexId a, VertexId b) {
    const Point2 one = points_[a.index()], other = points_[b.index()];
    const Sign farther = kernel::compare_distance(p, one, other);
    return farther == Sign::negative || (farther == Sign::zero && one < other);
  };
  // Turn about a site until a neighbour is nearer, then about that one.
  SideId first = locate(p).side, s = first;
  do {
    if (in.destination(s) != in.ghost && nearer(in.destination(s), in.origin(s))) {
      first = in.twin(s);
      s = first;
    }
    s = in.turn_about_origin(s);
  } while (s != first);
  return in.origin(s);
}

}  // namespace leonhard::delaunay
