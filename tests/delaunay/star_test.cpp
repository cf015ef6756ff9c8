// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/star.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

#include "leonhard/delaunay/algorithm.hpp"
#include "leonhard/delaunay/order/sorted_points.hpp"
#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::GhostTriangulation;
using delaunay::SideId;
using delaunay::Star;

/// Triangles, ghosts too, each from its least corner.
std::multiset<std::array<VertexId, 3>> triangles_of(const GhostTriangulation& in) {
  std::multiset<std::array<VertexId, 3>> all;
  for (std::size_t i = 0; i < in.triangle_count(); ++i) {
    const delaunay::AnyTriangleId t = delaunay::AnyTriangleId::from(i);
    std::array<VertexId, 3> corners{in.corner(t, 0), in.corner(t, 1), in.corner(t, 2)};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

/// The triangulation without the origin of a side.
GhostTriangulation without(GhostTriangulation in, std::span<const Point2> points, SideId side,
                           std::size_t few) {
  Star star;
  star.start(in, side);
  star.fill(in, points, few);
  const auto [lower, higher] = std::minmax(star.triangles().rbegin()[0], star.triangles().rbegin()[1]);
  in.erase(higher);
  in.erase(lower);
  REQUIRE_FALSE(in.validate().has_value());
  return in;
}

TEST_CASE("a_star_is_filled_alike_directly_and_from_the_whole_triangulation_of_its_link") {
  for (const shapes::NamedPoints& family : shapes::families()) {
    const delaunay::SortedPoints sorted = delaunay::sort_and_merge(family.points);
    if (sorted.points.size() < 5 || family.name == "collinear and one")
      continue;  // what is left must span triangles
    CAPTURE(family.name);
    const GhostTriangulation in =
        delaunay::triangulate_distinct(sorted.points, delaunay::Algorithm::watson, {}).triangulation;
    for (std::size_t i = 0; i < in.triangle_count(); ++i) {
      const SideId side = in.side(delaunay::AnyTriangleId::from(i), 2);
      if (in.origin(side) == GhostTriangulation::ghost) continue;
      const GhostTriangulation directly = without(in, sorted.points, side, 1000);
      CHECK(directly.triangle_count() == in.triangle_count() - 2);
      CHECK(triangles_of(directly) == triangles_of(without(in, sorted.points, side, 3)));
    }
  }
}

}  // namespace
}  // namespace leonhard
