// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/divide_and_conquer.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "leonhard/delaunay/topology/from_quad_edge.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/quad_edge.hpp"

namespace leonhard::delaunay {
namespace {

/// Names are those of the paper's figures.
class DivideAndConquer {
 public:
  /// sorted  lexicographically, at least two
  DivideAndConquer(const std::vector<Point2>& sorted, const Progress& progress)
      : points_(sorted), progress_(progress) {
    quads_.reserve(3 * sorted.size());
  }

  /// Triangulate all points; false if stopped. Afterwards triangles() has the triangles' faces numbered.
  bool run() {
    const Hull hull = triangulate(0, points_.size());
    if (!stopped_) number_faces(QuadEdge::sym(hull.left));
    return !stopped_;
  }
  [[nodiscard]] const QuadEdge& quads() const { return quads_; }
  [[nodiscard]] std::size_t triangle_count() const { return triangles_; }

 private:
  /// Where a triangulation is taken hold of.
  struct Hull {
    EdgeRef left{};   ///< counter-clockwise on the hull, from the leftmost point
    EdgeRef right{};  ///< clockwise on the hull, from the rightmost point
  };

  [[nodiscard]] const Point2& at(MaybeId<VertexId> v) const { return points_[(*v).index()]; }
  [[nodiscard]] const Point2& origin(EdgeRef e) const { return at(quads_.origin(e)); }
  [[nodiscard]] const Point2& destination(EdgeRef e) const { return at(quads_.destination(e)); }
  [[nodiscard]] bool is_left_of(const Point2& p, EdgeRef e) const {
    return kernel::orient2d(p, origin(e), destination(e)) == Sign::positive;
  }
  [[nodiscard]] bool is_right_of(const Point2& p, EdgeRef e) const {
    return kernel::orient2d(p, destination(e), origin(e)) == Sign::positive;
  }
  [[nodiscard]] static bool in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return kernel::incircle_perturbed(a, b, c, d) == Sign::positive;
  }
  [[nodiscard]] EdgeRef new_edge(std::size_t from, std::size_t to) {
    return quads_.make_edge(VertexId::from(from), VertexId::from(to));
  }

  Hull triangulate(std::size_t begin, std::size_t end) {
    if (end - begin <= 3) {
      work(end - begin);
      return end - begin == 2 ? two(begin) : three(begin);
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const Hull left = triangulate(begin, middle);
    if (stopped_) return {};
    const Hull right = triangulate(middle, end);
    if (stopped_) return {};
    return merge(left, right);
  }

  Hull two(std::size_t first) {
    const EdgeRef a = new_edge(first, first + 1);
    return {a, quads_.sym(a)};
  }

  Hull three(std::size_t first) {
    const EdgeRef a = new_edge(first, first + 1), b = new_edge(first + 1, first + 2);
    quads_.splice(quads_.sym(a), b);
    const Sign turn = kernel::orient2d(points_[first], points_[first + 1], points_[first + 2]);
    if (turn == Sign::zero) return {a, quads_.sym(b)};
    const EdgeRef c = quads_.connect(b, a);
    if (turn == Sign::positive) return {a, quads_.sym(b)};
    return {quads_.sym(c), c};
  }

  Hull merge(Hull left, Hull right) {
    EdgeRef base = lower_common_tangent(left, right);
    while (true) {
      const EdgeRef l = left_candidate(base), r = right_candidate(base);
      const bool l_valid = rises(l, base), r_valid = rises(r, base);
      if (!l_valid && !r_valid) return {left.left, right.right};
      if (!l_valid || (r_valid && in_circle(destination(l), origin(l), origin(r), destination(r))))
        base = quads_.connect(r, quads_.sym(base));
      else
        base = quads_.connect(quads_.sym(base), quads_.sym(l));
      if (work(0)) return {};
    }
  }

  /// The first cross edge, from right to left, with nothing below it. The hulls' ends move where it covers
  /// them.
  EdgeRef lower_common_tangent(Hull& left, Hull& right) {
    EdgeRef l = left.right, r = right.left;
    while (true) {
      if (is_left_of(origin(r), l))
        l = quads_.lnext(l);
      else if (is_right_of(origin(l), r))
        r = quads_.rprev(r);
      else
        break;
    }
    const EdgeRef base = quads_.connect(quads_.sym(r), l);
    if (quads_.origin(l) == quads_.origin(left.left)) left.left = quads_.sym(base);
    if (quads_.origin(r) == quads_.origin(right.right)) right.right = base;
    return base;
  }

  /// Does the candidate lead above the base, so that the bubble can meet its end?
  [[nodiscard]] bool rises(EdgeRef candidate, EdgeRef base) const {
    return is_right_of(destination(candidate), base);
  }

  /// The left half's edge to the first of its points that the bubble over the base meets; edges that the
  /// bubble bursts on the way are removed.
  EdgeRef left_candidate(EdgeRef base) {
    EdgeRef l = quads_.onext(quads_.sym(base));
    if (!rises(l, base)) return l;
    while (in_circle(destination(base), origin(base), destination(l), destination(quads_.onext(l)))) {
      const EdgeRef next = quads_.onext(l);
      quads_.remove(l);
      l = next;
    }
    return l;
  }

  EdgeRef right_candidate(EdgeRef base) {
    EdgeRef r = quads_.oprev(base);
    if (!rises(r, base)) return r;
    while (in_circle(destination(base), origin(base), destination(r), destination(quads_.oprev(r)))) {
      const EdgeRef next = quads_.oprev(r);
      quads_.remove(r);
      r = next;
    }
    return r;
  }

  /// Face ids for all faces but the one left of `outer`.
  void number_faces(EdgeRef outer) {
    std::vector<bool> is_outer(2 * quads_.record_count(), false);
    quads_.for_each_about_left(outer, [&](EdgeRef e) { is_outer[e.index() >> 1] = true; });
    quads_.for_each_directed_edge([&](EdgeRef e) {
      if (quads_.left(e) || is_outer[e.index() >> 1]) return;
      quads_.set_face(e, FaceId::from(triangles_++));
    });
  }

  /// Count work done: so many points, or one cross edge. True if the work is to stop.
  bool work(std::size_t points) {
    constexpr std::size_t poll = 4096;
    done_ += points;
    if (steps_++ % poll != 0) return stopped_;
    progress_("triangulate", static_cast<double>(done_) / static_cast<double>(points_.size()));
    stopped_ = progress_.stop_requested();
    return stopped_;
  }

  const std::vector<Point2>& points_;
  const Progress& progress_;
  QuadEdge quads_;
  std::size_t triangles_ = 0;
  std::size_t done_ = 0, steps_ = 0;
  bool stopped_ = false;
};

/// Corner v becomes vertex order[v].
void renumber(GhostTriangulation& in, const std::vector<std::uint32_t>& order) {
  const auto number = [&](VertexId v) {
    return v == GhostTriangulation::ghost ? v : VertexId{order[v.index()]};
  };
  for (std::size_t i = 0; i < in.triangle_count(); ++i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    in.set_corners(t, number(in.corner(t, 0)), number(in.corner(t, 1)), number(in.corner(t, 2)));
  }
}

}  // namespace

PointTriangulation triangulate_divide_and_conquer(std::span<const Point2> points,
                                                  const AlgorithmOptions& options) {
  if (points.size() < 3) return {TriangulateOutcome::too_few_points, {}};
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; });
  std::vector<Point2> sorted;
  sorted.reserve(points.size());
  for (const std::uint32_t i : order) sorted.push_back(points[i]);

  DivideAndConquer work(sorted, options.progress);
  if (!work.run()) return {TriangulateOutcome::stopped, {}};
  if (work.triangle_count() == 0) return {TriangulateOutcome::all_collinear, {}};
  PointTriangulation result{TriangulateOutcome::done, ghost_triangulation(work.quads())};
  renumber(result.triangulation, order);
  return result;
}

}  // namespace leonhard::delaunay
