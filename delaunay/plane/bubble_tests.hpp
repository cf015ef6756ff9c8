// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/filtered_sign.hpp"
#include "leonhard/kernel/pair.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

/// What one step of the rising bubble asks (Barth's notes 3.3a), filtered all at once: the tests share the base edge,
/// and the left and the right side go through the same arithmetic, two doubles at a time. Exact: what the filter
/// leaves is asked of the kernel's predicates, so the answers are theirs.
///
/// The base edge runs from l to r. On either side the candidate is the next hull vertex above it, and `behind` the
/// third corner of the triangle behind the hull edge from l, or r, to the candidate.
///
/// Error bounds (notation of filtered_sign.hpp). All vectors start at l and have coordinates wrong by u each. A cross
/// product of two of them is wrong by 4u (|x1 y2| + |y1 x2|), at most, so for orientations (3u + 16u^2) (|p| + |q|)
/// does in terms of the computed products p and q (Shewchuk 1997, section 4.3). In incircle's sum each of the three
/// terms |A|^2 (B x C) is wrong by 9u |A|^2 |B| |C| (4u of the square, 4u of the cross product, u of their product),
/// the two additions by at most 2u of all three: together 11u |A| |B| |C| (|A| + |B| + |C|), which is at most
/// 11/3 u (|A|^2 + |B|^2 + |C|^2)^2; 4u leaves room for the terms in u^2.
class BubbleTests {
 public:
  enum Side { left = 0, right = 1 };

  struct Corners {
    Point2 l, r;
    Point2 candidate[2];  ///< by side
    Point2 behind[2];
  };

  explicit BubbleTests(const Corners& at) : at_(at) {
    using kernel::both;
    const double base_x = at.r.x - at.l.x, base_y = at.r.y - at.l.y;
    base_square_ = base_x * base_x + base_y * base_y;
    x_ = kernel::Pair{at.candidate[left].x, at.candidate[right].x} - both(at.l.x);
    y_ = kernel::Pair{at.candidate[left].y, at.candidate[right].y} - both(at.l.y);
    const kernel::Pair behind_x = kernel::Pair{at.behind[left].x, at.behind[right].x} - both(at.l.x),
                       behind_y = kernel::Pair{at.behind[left].y, at.behind[right].y} - both(at.l.y);
    const kernel::Pair p = both(base_x) * y_, q = both(base_y) * x_;
    turn_ = p - q;
    turn_bound_ = both(3.3306690738754716e-16) * (kernel::absolute(p) + kernel::absolute(q));
    square_ = x_ * x_ + y_ * y_;
    const kernel::Pair behind_square = behind_x * behind_x + behind_y * behind_y;
    const kernel::Pair base_behind = both(base_x) * behind_y - both(base_y) * behind_x;
    const kernel::Pair candidate_behind = x_ * behind_y - y_ * behind_x;
    circle_ = square_ * base_behind - both(base_square_) * candidate_behind - behind_square * turn_;
    const kernel::Pair size = both(base_square_) + square_ + behind_square;
    circle_bound_ = both(0x1p-51) * (size * size);
  }

  /// Does the candidate lie above the base edge, strictly to its left?
  [[nodiscard]] bool is_above(Side side) const {
    const FilteredSign s = kernel::sign_if_beyond(turn_[side], turn_bound_[side]);
    if (s.is_certain()) [[likely]]
      return *s == Sign::positive;
    return kernel::orient2d(at_.l, at_.r, at_.candidate[side]) == Sign::positive;
  }
  /// Does the circle through base and candidate, which is above, hold the point behind?
  [[nodiscard]] bool holds_behind(Side side) const {
    const FilteredSign s = kernel::sign_if_beyond(circle_[side], circle_bound_[side]);
    if (s.is_certain()) [[likely]]
      return *s == Sign::positive;
    return holds(at_.candidate[side], at_.behind[side]);
  }
  /// Does the circle through base and left candidate hold the right one, both being above?
  [[nodiscard]] bool rises_to_the_right() const {
    const double candidates = x_[0] * y_[1] - y_[0] * x_[1];
    const double circle = square_[0] * turn_[1] - base_square_ * candidates - square_[1] * turn_[0];
    const double size = base_square_ + square_[0] + square_[1];
    const FilteredSign s = kernel::sign_if_beyond(circle, 0x1p-51 * (size * size));
    if (s.is_certain()) [[likely]]
      return *s == Sign::positive;
    return holds(at_.candidate[left], at_.candidate[right]);
  }

 private:
  using FilteredSign = kernel::FilteredSign;
  [[nodiscard]] bool holds(Point2 third, Point2 p) const {
    return kernel::incircle_perturbed(at_.l, at_.r, third, p) == Sign::positive;
  }

  const Corners& at_;
  double base_square_;
  kernel::Pair x_, y_, square_;  // of the candidates, seen from l
  kernel::Pair turn_, turn_bound_, circle_, circle_bound_;
};

}  // namespace leonhard::delaunay
