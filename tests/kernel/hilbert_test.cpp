// SPDX-License-Identifier: MIT
#include "leonhard/kernel/hilbert.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "leonhard/kernel/input_error.hpp"
#include "tests/kernel/orders.hpp"
#include "tests/kernel/point_families.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using namespace leonhard::testing;

namespace {

std::vector<Point2> uniform_points(Random& random, int count) {
  std::vector<Point2> points;
  for (int i = 0; i < count; ++i) points.push_back({uniform(random), uniform(random)});
  return points;
}

/// The corners of a 2^bits grid, shuffled.
std::vector<Point2> grid(Random& random, int bits) {
  std::vector<Point2> points;
  for (int x = 0; x < 1 << bits; ++x)
    for (int y = 0; y < 1 << bits; ++y) points.push_back({double(x), double(y)});
  std::ranges::shuffle(points, random);
  return points;
}

}  // namespace

TEST_CASE("hilbert_order_is_a_permutation_for_every_family_of_points") {
  Random random(61);
  for (const PointFamily& family : point_families()) {
    std::vector<Point2> points;
    for (int i = 0; i < 500; ++i)
      for (const Point2 p : family.draw(random)) points.push_back(p);
    CAPTURE(family.name);
    CHECK(is_permutation_of_indices(k::hilbert_order(points), points.size()));
  }
  CHECK(k::hilbert_order(std::vector<Point2>{}).empty());
  CHECK(k::hilbert_order(std::vector<Point2>{{3, 4}}) == std::vector<std::uint32_t>{0});
}

TEST_CASE("hilbert_curve_steps_to_an_adjacent_cell_on_a_grid") {
  // The grid's outermost points lie on the bounding square, so cells of the curve hold one grid point each.
  Random random(62);
  const std::vector<Point2> points = grid(random, 5);
  const auto order = k::hilbert_order(points);
  CHECK(points[order.front()] == Point2{0, 0});
  CHECK(points[order.back()] == Point2{31, 0});
  for (std::size_t i = 1; i < order.size(); ++i)
    REQUIRE(leonhard::distance(points[order[i]], points[order[i - 1]]) == 1);
}

TEST_CASE("hilbert_tour_of_uniform_points_is_short") {
  // The tour through n uniform points of a unit square is about 0.92 sqrt(n) long along a Hilbert curve (Platzman and
  // Bartholdi, Journal of the ACM 36 (1989)), 0.52 n in random order.
  Random random(63);
  const int count = 20'000;
  const std::vector<Point2> points = uniform_points(random, count);
  const auto order = k::hilbert_order(points);
  CHECK(tour_length(points, order) / 2 < 1.1 * std::sqrt(count));  // the square has side 2
}

TEST_CASE("hilbert_order_depends_on_points_alone_not_on_their_order") {
  Random random(64);
  std::vector<Point2> points = uniform_points(random, 3000);
  const auto visited = [](const std::vector<Point2>& p) {
    std::vector<Point2> tour;
    for (const std::uint32_t i : k::hilbert_order(p)) tour.push_back(p[i]);
    return tour;
  };
  const auto tour = visited(points);
  CHECK(k::hilbert_order(points) == k::hilbert_order(points));
  std::ranges::shuffle(points, random);
  CHECK(visited(points) == tour);
}

TEST_CASE("hilbert_order_takes_equal_points_by_index_and_close_ones_lexicographically") {
  const std::vector<Point2> equal{{1, 1}, {1, 1}, {1, 1}};
  CHECK(k::hilbert_order(equal) == std::vector<std::uint32_t>{0, 1, 2});
  // All but the last lie in one cell of the grid.
  const std::vector<Point2> close{{0x3p-50, 0}, {0, 0x1p-50}, {0, 0}, {-0.0, 0}, {0x3p-50, 0}, {1, 0}};
  CHECK(k::hilbert_order(close) == std::vector<std::uint32_t>{2, 3, 1, 0, 4, 5});
}

TEST_CASE("hilbert_order_survives_extreme_boxes") {
  const double largest = std::numeric_limits<double>::max(),
               smallest = std::numeric_limits<double>::denorm_min();
  const std::vector<Point2> huge{
      {largest, -largest}, {-largest, -largest}, {largest, largest}, {-largest, largest}};
  CHECK(k::hilbert_order(huge) == std::vector<std::uint32_t>{1, 3, 2, 0});
  const std::vector<Point2> tiny{{smallest, 0}, {0, 0}, {smallest, smallest}, {0, smallest}};
  CHECK(k::hilbert_order(tiny) == std::vector<std::uint32_t>{1, 3, 2, 0});
  const std::vector<Point2> line{{3, 5}, {1, 5}, {2, 5}, {0, 5}};
  CHECK(k::hilbert_order(line) == std::vector<std::uint32_t>{3, 1, 2, 0});
}

TEST_CASE("hilbert_order_refuses_points_that_are_not_finite") {
  const std::vector<Point2> points{{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}};
  CHECK_THROWS_WITH_AS(static_cast<void>(k::hilbert_order(points)),
                       "points: point 1 is not finite; remove NaN and infinite coordinates",
                       leonhard::InputError);
}
