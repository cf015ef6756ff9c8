// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/plane/green_sibson.hpp"

#include "leonhard/delaunay/plane/swap_insertion.hpp"
#include "leonhard/delaunay/topology/locate.hpp"

namespace leonhard::delaunay {
namespace {

/// The recursive algorithm's three steps as Barth's notes 3.3b number them.
class GreenSibson {
 public:
  explicit GreenSibson(std::span<const Point2> points) : points_(points) {}

  void start(const GhostTriangulation&) {}

  std::size_t insert(GhostTriangulation& in, VertexId v) {
    // Step 1: locate the cell that encloses the site.
    const Location at = locate(in, points_, last_, points_[v.index()], coin_);
    // Steps 2 and 3: connect the site to the vertices about it, swap edges forward.
    NoHistory none;
    const std::size_t made = insertion_.insert(in, points_, v, at, none);
    // The cell keeps its number and has the site as a corner, or its neighbour about the site does.
    last_ = in.triangle(at.side);
    if (in.is_ghost(last_)) last_ = real_neighbour(in, last_);
    return made;
  }

 private:
  static AnyTriangleId real_neighbour(const GhostTriangulation& in, AnyTriangleId ghost) {
    return in.triangle(in.twin(in.side(ghost, 0)));
  }

  std::span<const Point2> points_;
  AnyTriangleId last_{0};  // where the next walk starts: real
  SwapInsertion insertion_;
  Coin coin_;
};

}  // namespace

Construction insert_green_sibson(std::span<const Point2> points, std::vector<std::uint32_t> order,
                                 const Progress& progress) {
  return insert_in_order(points, order, progress, GreenSibson(points));
}

PointTriangulation triangulate_green_sibson(std::span<const Point2> points, const AlgorithmOptions& options) {
  return insert_green_sibson(points, order_in_rounds(points.size()), options.progress).result;
}

}  // namespace leonhard::delaunay
