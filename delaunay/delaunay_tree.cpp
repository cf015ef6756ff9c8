// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/delaunay_tree.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "leonhard/delaunay/order/insert_in_order.hpp"
#include "leonhard/delaunay/plane/swap_insertion.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/words.hpp"

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
    if (at.kind == Location::Kind::on_vertex)
      throw InputError(
          "point " + std::to_string(v.raw),
          "is at " + mesh::words(p) + " as point " + std::to_string(in.origin(at.side).raw) + " is",
          "give distinct points");
    return insertion_.insert(in, points_, v, at, history_);
  }

 private:
  std::span<const Point2> points_;
  TriangleHistory& history_;
  SwapInsertion insertion_;
};

void check_input(std::span<const Point2> points, std::span<const std::uint32_t> order) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InputError("point " + std::to_string(i), "is at " + mesh::words(points[i]),
                       "give finite coordinates");
  if (order.size() != points.size())
    throw InputError(
        "order", std::to_string(order.size()) + " numbers for " + std::to_string(points.size()) + " points",
        "give a permutation of the points");
  std::vector<char> seen(points.size(), 0);
  for (const std::uint32_t i : order) {
    if (i >= seen.size() || seen[i] != 0)
      throw InputError("order", std::to_string(i) + (i >= seen.size() ? " is no point" : " comes twice"),
                       "give a permutation of the points");
    seen[i] = 1;
  }
}

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
  check_input(points_, order_);
  (void)bring_triangle_to_front(points_, order_);  // as insert_in_order will do: order() tells the truth
  Construction made = insert_in_order(points_, order_, progress, TreeInserter(points_, history_));
  outcome_ = made.result.outcome;
  triangulation_ = std::move(made.result.triangulation);
  structural_changes_ = made.structural_changes;
}

Location DelaunayTree::locate(Point2 p) const {
  if (outcome_ != TriangulateOutcome::done)
    throw InputError("DelaunayTree", "there are no triangles to ask", "look at outcome() first");
  if (!is_finite(p)) throw InputError("point", "is at " + mesh::words(p), "give finite coordinates");
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
