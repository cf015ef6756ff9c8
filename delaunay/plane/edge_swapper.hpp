// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

/// Do the two real triangles at side s form a strictly convex quadrilateral?
[[nodiscard]] inline bool is_strictly_convex(const GhostTriangulation& in, std::span<const Point2> points,
                                             SideId s) {
  const Point2 from = points[in.origin(s).index()], to = points[in.destination(s).index()],
               left = points[in.apex(s).index()], right = points[in.apex(in.twin(s)).index()];
  return kernel::orient2d(right, left, from) == Sign::positive &&
         kernel::orient2d(left, right, to) == Sign::positive;
}

/// Swaps edges by a criterion of swap_criterion.hpp until none is suspect: a swap makes the four edges around
/// suspect, and where the criterion looks around, those of the triangles beyond as well. These may be edges
/// that were found good before: the backward propagation of Barth's notes, end of 3.3b.
template <class Criterion>
class EdgeSwapper {
 public:
  /// is_fixed  asked for an edge's side before a swap; the edge stays if true. May be empty.
  EdgeSwapper(GhostTriangulation& in, std::span<const Point2> points, Criterion criterion,
              std::function<bool(SideId)> is_fixed = {})
      : in_(in), points_(points), criterion_(criterion), is_fixed_(std::move(is_fixed)) {}

  void suspect(SideId s) {
    if (waiting_.size() < 3 * in_.triangle_count()) waiting_.resize(3 * in_.triangle_count(), 0);
    if (waiting_[in_.slot(s)] || waiting_[in_.slot(in_.twin(s))]) return;
    waiting_[in_.slot(s)] = 1;
    suspects_.push_back(s);
  }
  /// Suspect a new side's edge and, where the criterion looks around, those of the triangle beyond.
  void suspect_around(SideId s) {
    suspect(s);
    if constexpr (Criterion::looks_around) {
      suspect(in_.next(in_.twin(s)));
      suspect(in_.previous(in_.twin(s)));
    }
  }
  void suspect_all() {
    for (std::size_t t = in_.triangle_count(); t-- > 0;)
      for (unsigned i = 3; i-- > 0;) suspect(in_.side(AnyTriangleId::from(t), i));
  }

  [[nodiscard]] std::size_t suspect_count() const { return suspects_.size(); }
  [[nodiscard]] std::size_t swaps() const { return swaps_; }

  /// Look at the last suspect: swap its edge if that is better. There must be one.
  ///
  /// A side's number may have come to stand for another edge since it was suspected. Nothing is missed: a
  /// swap suspects all edges whose sides it renumbers.
  void step() {
    const SideId s = suspects_.back();
    suspects_.pop_back();
    waiting_[in_.slot(s)] = 0;
    if (in_.is_ghost(in_.triangle(s)) || in_.is_ghost(in_.triangle(in_.twin(s)))) return;
    if constexpr (!Criterion::implies_convex)
      if (!is_strictly_convex(in_, points_, s)) return;
    if (!criterion_.improves(in_, points_, s)) return;
    if (is_fixed_ && is_fixed_(s)) return;
    ++swaps_;
    for (const auto& moved : in_.flip(s).moved) suspect_around(moved.second);
  }
  void run() {
    while (!suspects_.empty()) step();
  }

 private:
  GhostTriangulation& in_;
  std::span<const Point2> points_;
  Criterion criterion_;
  std::function<bool(SideId)> is_fixed_;
  std::vector<char> waiting_;  ///< one a slot: the side is among the suspects
  std::vector<SideId> suspects_;
  std::size_t swaps_ = 0;
};

}  // namespace leonhard::delaunay
