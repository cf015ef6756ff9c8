// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/hull_merge.hpp"

#include <cassert>

#include "leonhard/delaunay/plane/bubble_tests.hpp"

namespace leonhard::delaunay {
namespace {

/// Lexicographic order for a cut. By y is by x after turning the plane clockwise by a right angle, so that what is
/// lower, upper, left and right of a cut turns with it; the bubble is told of cuts by x only.
template <Cut cut>
bool less(Point2 p, Point2 q) {
  if constexpr (cut == Cut::by_x) return p.x < q.x || (p.x == q.x && p.y < q.y);
  return p.y < q.y || (p.y == q.y && p.x > q.x);
}

/// The bubble between a left part and a right one. A ghost (ghost, u, v) stands for the hull edge from v to u, the
/// hull walked counter-clockwise; over its side 1 lies the ghost before it, over its side 2 the one after it.
class Bubble {
 public:
  Bubble(std::span<const Point2> points, GhostTriangulation& in, const Part& left, const Part& right)
      : points_(points),
        in_(in),
        left_is_point_(left.point_count() == 1),
        right_is_point_(right.point_count() == 1),
        bottom_{2 * right.first - 2},
        top_{2 * right.first - 1},
        l_{left.first},
        r_{right.first},
        left_ghost_(bottom_),
        right_ghost_(bottom_) {}

  template <Cut cut>
  void start_between(const Part& left, const Part& right);
  void sink();
  void put_bottom();
  void rise();
  [[nodiscard]] AnyTriangleId put_top();

 private:
  static constexpr VertexId ghost = GhostTriangulation::ghost;

  [[nodiscard]] Point2 at(VertexId v) const { return points_[v.index()]; }
  [[nodiscard]] AnyTriangleId over(AnyTriangleId t, unsigned side) const {
    return in_.triangle(in_.twin(in_.side(t, side)));
  }
  [[nodiscard]] AnyTriangleId hull_before(AnyTriangleId g) const { return over(g, 1); }
  [[nodiscard]] AnyTriangleId hull_after(AnyTriangleId g) const { return over(g, 2); }
  [[nodiscard]] bool is_below(VertexId v) const {
    return kernel::orient2d(at(l_), at(r_), at(v)) == Sign::negative;
  }
  template <class Better>
  [[nodiscard]] AnyTriangleId extreme(AnyTriangleId g, const Better& better) const;
  [[nodiscard]] VertexId behind(SideId hull_edge) const;
  void drop_left_edge(SideId behind);
  void drop_right_edge(SideId behind);
  void step(bool to_the_right);

  std::span<const Point2> points_;
  GhostTriangulation& in_;
  bool left_is_point_, right_is_point_;
  AnyTriangleId bottom_, top_;  // the ghosts below the lowest and above the highest edge between the parts
  VertexId l_, r_;              // the base edge
  AnyTriangleId left_ghost_;    // its v is l, its u the left candidate; bottom_ if there is none
  AnyTriangleId right_ghost_;   // its u is r, its v the right candidate; bottom_ if there is none
  SideId base_{};               // the base edge's side in the triangle below it
};

/// The ghost whose v is the best vertex of the hull; coordinates along a convex hull rise once and fall once.
template <class Better>
AnyTriangleId Bubble::extreme(AnyTriangleId g, const Better& better) const {
  const auto start = [&](AnyTriangleId t) { return in_.corner(t, 2); };
  const AnyTriangleId from = g;
  for (AnyTriangleId next = hull_before(g); better(at(start(next)), at(start(g))); next = hull_before(g))
    g = next;
  if (g != from) return g;
  for (AnyTriangleId next = hull_after(g); better(at(start(next)), at(start(g))); next = hull_after(g))
    g = next;
  return g;
}

/// l and r become the vertices next to the cut.
template <Cut cut>
void Bubble::start_between(const Part& left, const Part& right) {
  if (!left_is_point_) {
    left_ghost_ = extreme(left.hull, [](Point2 p, Point2 q) { return less<cut>(q, p); });
    l_ = in_.corner(left_ghost_, 2);
  }
  if (!right_is_point_) {
    right_ghost_ = hull_before(extreme(right.hull, [](Point2 p, Point2 q) { return less<cut>(p, q); }));
    r_ = in_.corner(right_ghost_, 1);
  }
}

/// The base edge becomes the lower common tangent.
void Bubble::sink() {
  bool moved = true;
  while (moved) {
    moved = false;
    while (!left_is_point_ && is_below(in_.corner(hull_before(left_ghost_), 2))) {
      left_ghost_ = hull_before(left_ghost_);
      l_ = in_.corner(left_ghost_, 2);
      moved = true;
    }
    while (!right_is_point_ && is_below(in_.corner(hull_after(right_ghost_), 1))) {
      right_ghost_ = hull_after(right_ghost_);
      r_ = in_.corner(right_ghost_, 1);
      moved = true;
    }
  }
}

/// The ghost below the lower common tangent. On the side of a single point it stays open until the top is put.
void Bubble::put_bottom() {
  in_.set_corners(bottom_, ghost, r_, l_);
  for (unsigned i = 0; i < 3; ++i) in_.link(in_.side(bottom_, i), in_.side(bottom_, i));
  if (!left_is_point_) in_.link(in_.side(bottom_, 1), in_.twin(in_.side(left_ghost_, 1)));
  if (!right_is_point_) in_.link(in_.side(bottom_, 2), in_.twin(in_.side(right_ghost_, 2)));
  base_ = in_.side(bottom_, 0);
}

/// The vertex behind a hull edge, given by its side in the triangle there; the ghost if that is a ghost too.
VertexId Bubble::behind(SideId hull_edge) const {
  return in_.is_ghost(in_.triangle(hull_edge)) ? ghost : in_.apex(hull_edge);
}

/// Remove the hull edge from l to the left candidate: flip it with its ghost. Two ghosts stay, about the vertex behind.
void Bubble::drop_left_edge(SideId behind) {
  const AnyTriangleId g = left_ghost_, t = in_.triangle(behind);
  const VertexId candidate = in_.corner(g, 1), x = in_.apex(behind);
  const SideId beyond_l = in_.twin(in_.previous(behind)), beyond_candidate = in_.twin(in_.next(behind)),
               after = in_.twin(in_.side(g, 2));
  in_.set_corners(g, ghost, x, l_);
  in_.set_corners(t, ghost, candidate, x);
  in_.link(in_.side(g, 0), beyond_l);
  in_.link(in_.side(t, 0), beyond_candidate);
  in_.link(in_.side(t, 2), after);
  in_.link(in_.side(t, 1), in_.side(g, 2));
}

void Bubble::drop_right_edge(SideId behind) {
  const AnyTriangleId g = right_ghost_, t = in_.triangle(behind);
  const VertexId candidate = in_.corner(g, 2), x = in_.apex(behind);
  const SideId beyond_r = in_.twin(in_.next(behind)), beyond_candidate = in_.twin(in_.previous(behind)),
               before = in_.twin(in_.side(g, 1));
  in_.set_corners(g, ghost, r_, x);
  in_.set_corners(t, ghost, x, candidate);
  in_.link(in_.side(g, 0), beyond_r);
  in_.link(in_.side(t, 0), beyond_candidate);
  in_.link(in_.side(t, 1), before);
  in_.link(in_.side(t, 2), in_.side(g, 1));
}

/// The ghost of the edge chosen becomes the triangle above the base edge, its upper side the new base edge. Written
/// without branches, because which side is next is as good as random.
void Bubble::step(bool to_the_right) {
  const AnyTriangleId t = to_the_right ? right_ghost_ : left_ghost_;
  const unsigned lower = to_the_right ? 2 : 1, upper = 3 - lower;
  const AnyTriangleId next = over(t, upper);
  const VertexId left_candidate = in_.corner(left_ghost_, 1), right_candidate = in_.corner(right_ghost_, 2);
  in_.set_corner(t, 0, to_the_right ? l_ : r_);
  in_.link(in_.side(t, lower), base_);
  base_ = in_.side(t, upper);
  l_ = to_the_right ? l_ : left_candidate;
  r_ = to_the_right ? right_candidate : r_;
  left_ghost_ = to_the_right ? left_ghost_ : next;
  right_ghost_ = to_the_right ? next : right_ghost_;
}

void Bubble::rise() {
  using Tests = BubbleTests;
  while (true) {
    const bool has_left = left_ghost_ != bottom_, has_right = right_ghost_ != bottom_;
    const VertexId left = in_.corner(left_ghost_, 1), right = in_.corner(right_ghost_, 2);
    const SideId left_edge = in_.twin(in_.side(left_ghost_, 0)),
                 right_edge = in_.twin(in_.side(right_ghost_, 0));
    const VertexId behind_left = behind(left_edge), behind_right = behind(right_edge);
    const bool left_has_behind = behind_left != ghost, right_has_behind = behind_right != ghost;
    const BubbleTests::Corners corners{
        at(l_),
        at(r_),
        {at(left), at(right)},
        {at(left_has_behind ? behind_left : left), at(right_has_behind ? behind_right : right)}};
    const BubbleTests tests(corners);
    const bool left_rises = has_left && tests.is_above(Tests::left),
               right_rises = has_right && tests.is_above(Tests::right);
    if (!left_rises && !right_rises) return;
    const bool drop_left = left_rises && left_has_behind && tests.holds_behind(Tests::left),
               drop_right = right_rises && right_has_behind && tests.holds_behind(Tests::right);
    if (drop_left) drop_left_edge(left_edge);
    if (drop_right) drop_right_edge(right_edge);
    if (!drop_left && !drop_right) step(right_rises && (!left_rises || tests.rises_to_the_right()));
  }
}

/// The ghost above the upper common tangent, which is the base edge now.
AnyTriangleId Bubble::put_top() {
  in_.set_corners(top_, ghost, l_, r_);
  in_.link(in_.side(top_, 0), base_);
  in_.link(in_.side(top_, 2), in_.side(left_ghost_, 1));
  in_.link(in_.side(top_, 1), in_.side(right_ghost_, 2));
  return top_;
}

template <Cut cut>
Part merge_by(std::span<const Point2> points, GhostTriangulation& in, const Part& lower, const Part& upper) {
  Bubble bubble(points, in, lower, upper);
  bubble.start_between<cut>(lower, upper);
  bubble.sink();
  bubble.put_bottom();
  bubble.rise();
  return {lower.first, upper.last, bubble.put_top()};
}

/// Two points: two ghosts, back to back.
Part edge(GhostTriangulation& in, std::uint32_t first) {
  const AnyTriangleId below{2 * first}, above{2 * first + 1};
  const VertexId a{first}, b{first + 1};
  in.set_corners(below, GhostTriangulation::ghost, b, a);
  in.set_corners(above, GhostTriangulation::ghost, a, b);
  in.link(in.side(below, 0), in.side(above, 0));
  in.link(in.side(below, 1), in.side(above, 2));
  in.link(in.side(below, 2), in.side(above, 1));
  return {first, first + 2, above};
}

/// Three points that turn: a triangle and its three ghosts.
Part triangle(GhostTriangulation& in, std::uint32_t first, Sign turn) {
  const VertexId a{first}, b{first + (turn == Sign::positive ? 1U : 2U)},
      c{first + (turn == Sign::positive ? 2U : 1U)};
  in.set_first_triangle(AnyTriangleId{2 * first}, a, b, c);
  return {first, first + 3, AnyTriangleId{2 * first + 1}};
}

}  // namespace

Part merge(std::span<const Point2> points, GhostTriangulation& in, const Part& lower, const Part& upper,
           Cut cut) {
  assert(lower.last == upper.first);
  const std::uint32_t first = lower.first, count = upper.last - first;
  if (count == 2) return edge(in, first);
  if (count == 3) {
    const Sign turn = kernel::orient2d(points[first], points[first + 1], points[first + 2]);
    if (turn != Sign::zero) return triangle(in, first, turn);
  }
  return cut == Cut::by_x ? merge_by<Cut::by_x>(points, in, lower, upper)
                          : merge_by<Cut::by_y>(points, in, lower, upper);
}

}  // namespace leonhard::delaunay
