// SPDX-License-Identifier: MIT
// Four affinely independent points, or what the points span.
#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include "leonhard/delaunay/space/first_tetrahedron.hpp"
#include "leonhard/kernel/predicates3.hpp"

namespace leonhard {
namespace {

using delaunay::Extent;
using delaunay::first_tetrahedron;
using delaunay::FirstTetrahedron;
using Points = std::vector<Point3>;

TEST_CASE("the_extent_of_points_is_told_exactly") {
  CHECK(first_tetrahedron(Points{}).extent == Extent::nothing);
  CHECK(first_tetrahedron(Points{{1, 2, 3}}).extent == Extent::point);
  CHECK(first_tetrahedron(Points{{0, 0, 0}, {-0.0, 0, 0}}).extent == Extent::point);
  CHECK(first_tetrahedron(Points{{0, 0, 0}, {3, 1, 2}, {6, 2, 4}, {-3, -1, -2}}).extent == Extent::line);
  CHECK(first_tetrahedron(Points{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}).extent == Extent::line);
  CHECK(first_tetrahedron(Points{{0, 0, 0}, {0, 1, 0}, {0, 2, 5e-324}}).extent == Extent::plane);
  CHECK(first_tetrahedron(Points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, -1, 0}, {1, 1, -1}}).extent ==
        Extent::plane);
  CHECK(first_tetrahedron(
            Points{{1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e300}, {1e300, 1e300, -1e300}, {0, 0, 5e-324}})
            .extent == Extent::space);
}

TEST_CASE("each_point_taken_is_the_first_in_the_order_that_is_independent") {
  const Points points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  const std::vector<std::uint32_t> order{1, 1, 2, 0, 4, 3, 6, 5};
  const FirstTetrahedron found = first_tetrahedron(points, order);
  REQUIRE(found.extent == Extent::space);
  const auto& [a, b, c, d] = found.points;
  CHECK(a + b == 3);
  CHECK(c == 4);
  CHECK(d == 6);
  CHECK(kernel::orient3d(points[a], points[b], points[c], points[d]) == Sign::positive);
  const FirstTetrahedron other = first_tetrahedron(points);
  CHECK(other.points[3] == 5);
  CHECK(kernel::orient3d(points[other.points[0]], points[other.points[1]], points[other.points[2]],
                         points[other.points[3]]) == Sign::positive);
}

}  // namespace
}  // namespace leonhard
