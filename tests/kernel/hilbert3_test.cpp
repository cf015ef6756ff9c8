// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "leonhard/kernel/hilbert.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "tests/kernel/orders.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using leonhard::Point3;
using namespace leonhard::testing;

namespace {

std::vector<Point3> uniform_points(Random& random, int count) {
  std::vector<Point3> points;
  for (int i = 0; i < count; ++i) points.push_back({uniform(random), uniform(random), uniform(random)});
  return points;
}

}  // namespace

TEST_CASE("hilbert_order_of_space_is_a_permutation_for_every_family_of_points") {
  Random random(91);
  for (const PointFamily3& family : point_families3()) {
    std::vector<Point3> points;
    for (int i = 0; i < 400; ++i)
      for (const Point3& p : family.draw(random)) points.push_back(p);
    CAPTURE(family.name);
    CHECK(is_permutation_of_indices(k::hilbert_order(points), points.size()));
  }
  CHECK(k::hilbert_order(std::vector<Point3>{}).empty());
  CHECK(k::hilbert_order(std::vector<Point3>{{3, 4, 5}}) == std::vector<std::uint32_t>{0});
}

TEST_CASE("hilbert_curve_of_space_steps_to_an_adjacent_cell_on_a_grid") {
  // The grid's outermost points lie on the bounding cube, so cells of the curve hold one grid point each.
  constexpr int side = 16;
  std::vector<Point3> points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) points.push_back({double(x), double(y), double(z)});
  Random random(92);
  std::ranges::shuffle(points, random);
  const auto order = k::hilbert_order(points);
  CHECK(points[order.front()] == Point3{0, 0, 0});
  CHECK(points[order.back()] == Point3{side - 1, 0, 0});
  for (std::size_t i = 1; i < order.size(); ++i)
    REQUIRE(leonhard::distance(points[order[i]], points[order[i - 1]]) == 1);
}

TEST_CASE("hilbert_tour_of_uniform_points_of_space_is_short") {
  // The tour has about n steps of n^(-1/3) of the cube's side; in random order 0.66 n.
  Random random(93);
  const int count = 20'000;
  const std::vector<Point3> points = uniform_points(random, count);
  const double steps = tour_length(points, k::hilbert_order(points)) / 2 * std::cbrt(count) / count;
  CHECK(steps < 1.1);  // the cube has side 2
}

TEST_CASE("hilbert_order_of_space_depends_on_points_alone_not_on_their_order") {
  Random random(94);
  std::vector<Point3> points = uniform_points(random, 3000);
  const auto visited = [](const std::vector<Point3>& p) {
    std::vector<Point3> tour;
    for (const std::uint32_t i : k::hilbert_order(p)) tour.push_back(p[i]);
    return tour;
  };
  const auto tour = visited(points);
  std::ranges::shuffle(points, random);
  CHECK(visited(points) == tour);
}

TEST_CASE("hilbert_order_of_space_survives_extreme_boxes_and_takes_equal_points_by_index") {
  const double largest = std::numeric_limits<double>::max(),
               smallest = std::numeric_limits<double>::denorm_min();
  const std::vector<Point3> huge{{largest, -largest, -largest}, {-largest, -largest, -largest}};
  CHECK(k::hilbert_order(huge) == std::vector<std::uint32_t>{1, 0});
  const std::vector<Point3> tiny{{smallest, 0, 0}, {0, 0, 0}};
  CHECK(k::hilbert_order(tiny) == std::vector<std::uint32_t>{1, 0});
  const std::vector<Point3> equal{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  CHECK(k::hilbert_order(equal) == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("hilbert_order_of_space_refuses_points_that_are_not_finite") {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, std::numeric_limits<double>::infinity()}};
  CHECK_THROWS_WITH_AS(static_cast<void>(k::hilbert_order(points)),
                       "points: point 1 is not finite; remove NaN and infinite coordinates",
                       leonhard::InputError);
}
