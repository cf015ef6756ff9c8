// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/watson.hpp"

#include "leonhard/delaunay/topology/cavity.hpp"
#include "leonhard/delaunay/topology/conflict.hpp"
#include "leonhard/delaunay/topology/locate.hpp"

namespace leonhard::delaunay {
namespace {

/// The steps of Watson's algorithm as Barth's notes 3.3b number them.
class Watson {
 public:
  explicit Watson(std::span<const Point2> points) : points_(points) {}

  void start(const GhostTriangulation&) {}

  std::size_t insert(GhostTriangulation& in, VertexId v) {
    // Step 1: a new site.
    const Point2 p = points_[v.index()];
    // Step 2: any triangle whose circumcircle contains it, here the triangle that contains it itself.
    cavity_.start(in, walk(in, points_, last_, p, coin_));
    // Step 3: tree search for the other deletable triangles. Step 4: the edges that belong to only one
    // deletable triangle are those over which the search does not go; it meets them in counter-clockwise
    // order.
    cavity_.grow(in, [&](SideId inner) { return in_conflict(in, points_, in.triangle(in.twin(inner)), p); });
    // Step 5: these edges are connected to the site.
    cavity_.fill(in, v);
    last_ = real_one(in, cavity_.triangles());
    return cavity_.triangles().size();
  }

 private:
  static AnyTriangleId real_one(const GhostTriangulation& in, const std::vector<AnyTriangleId>& fan) {
    std::size_t i = 0;
    while (in.is_ghost(fan[i])) ++i;
    return fan[i];
  }

  std::span<const Point2> points_;
  AnyTriangleId last_{0};  // where the next walk starts: real
  Cavity cavity_;
  Coin coin_;
};

}  // namespace

Construction insert_watson(std::span<const Point2> points, std::vector<std::uint32_t> order,
                           const Progress& progress) {
  return insert_in_order(points, order, progress, Watson(points));
}

PointTriangulation triangulate_watson(std::span<const Point2> points, const AlgorithmOptions& options) {
  return insert_watson(points, order_in_rounds(points.size()), options.progress).result;
}

}  // namespace leonhard::delaunay
