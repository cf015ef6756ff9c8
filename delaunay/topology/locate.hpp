// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "leonhard/delaunay/topology/ghost_triangulation.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/predicates.hpp"

namespace leonhard::delaunay {

/// One bit after another, without memory of the coordinates: keeps a walk from going round in a circle, which
/// it could do in a triangulation that is not Delaunay. The answer of a walk does not depend on it.
class Coin {
 public:
  [[nodiscard]] unsigned flip() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return (state_ >> 9) & 1;
  }

 private:
  std::uint32_t state_ = 0x9e3779b9;
};

/// The triangle that holds p, reached by a remembering visibility walk (Devillers, Pion and Teillaud 2002)
/// from `from`, which is real; or a ghost triangle whose edge has p strictly on its outer side.
///
/// The domain must be convex, or nothing may lie between `from` and p.
[[nodiscard]] inline AnyTriangleId walk(const GhostTriangulation& in, std::span<const Point2> points,
                                        AnyTriangleId from, Point2 p, Coin& coin) {
  const auto beyond = [&](SideId s) {
    return kernel::orient2d(points[in.origin(s).index()], points[in.destination(s).index()], p) ==
           Sign::negative;
  };
  // At first all three sides are asked, then only the two that were not just crossed.
  SideId entered = in.side(from, 0);
  if (beyond(entered)) {
    entered = in.twin(entered);
    if (in.is_ghost(in.triangle(entered))) return in.triangle(entered);
  }
  while (true) {
    SideId one = in.next(entered), other = in.previous(entered);
    if (coin.flip() != 0) std::swap(one, other);
    if (beyond(one))
      entered = in.twin(one);
    else if (beyond(other))
      entered = in.twin(other);
    else
      return in.triangle(entered);
    if (in.is_ghost(in.triangle(entered))) return in.triangle(entered);
  }
}

/// Where a point lies: a closed set of answers.
struct Location {
  enum class Kind {
    outside,      ///< outside the domain; side: side 0 of a ghost triangle, the point strictly to its left
    in_triangle,  ///< strictly inside; side: any side of that triangle
    on_side,      ///< strictly between the ends of side
    on_vertex,    ///< at the origin of side
  };
  Kind kind;
  SideId side;
};

/// Where p lies in a triangle that holds it; or outside, if the triangle is a ghost with p strictly to the
/// left of its edge.
[[nodiscard]] Location location_in(const GhostTriangulation& in, std::span<const Point2> points,
                                   AnyTriangleId t, Point2 p);

/// Locate p by a walk from the real triangle `from`; the same conditions as for walk.
[[nodiscard]] Location locate(const GhostTriangulation& in, std::span<const Point2> points,
                              AnyTriangleId from, Point2 p, Coin& coin);

}  // namespace leonhard::delaunay
