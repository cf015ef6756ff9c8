// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/locate.hpp"

namespace leonhard::delaunay {

Location location_in(const GhostTriangulation& in, std::span<const Point2> points, AnyTriangleId t,
                     Point2 p) {
  if (in.is_ghost(t)) return {Location::Kind::outside, in.side(t, 0)};
  for (unsigned i = 0; i < 3; ++i)
    if (points[in.origin(in.side(t, i)).index()] == p) return {Location::Kind::on_vertex, in.side(t, i)};
  for (unsigned i = 0; i < 3; ++i) {
    const SideId s = in.side(t, i);
    if (kernel::orient2d(points[in.origin(s).index()], points[in.destination(s).index()], p) == Sign::zero)
      return {Location::Kind::on_side, s};
  }
  return {Location::Kind::in_triangle, in.side(t, 0)};
}

Location locate(const GhostTriangulation& in, std::span<const Point2> points, AnyTriangleId from, Point2 p,
                Coin& coin) {
  return location_in(in, points, walk(in, points, from, p, coin), p);
}

}  // namespace leonhard::delaunay
