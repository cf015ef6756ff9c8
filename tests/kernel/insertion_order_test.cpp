// SPDX-License-Identifier: MIT
#include "leonhard/kernel/insertion_order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "leonhard/kernel/hilbert.hpp"
#include "tests/kernel/orders.hpp"
#include "tests/kernel/point_families3.hpp"

namespace k = leonhard::kernel;
using leonhard::Point2;
using leonhard::Point3;
using namespace leonhard::testing;

namespace {

/// How often the order falls back along the curve: where a round begins.
int falls(const std::vector<std::uint32_t>& order, const std::vector<std::uint32_t>& curve) {
  std::vector<std::size_t> place(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) place[curve[i]] = i;
  int count = 0;
  for (std::size_t i = 1; i < order.size(); ++i) count += place[order[i]] < place[order[i - 1]];
  return count;
}

}  // namespace

TEST_CASE("brio_order_is_a_permutation_in_about_log2_n_rounds_along_the_curve") {
  Random random(101);
  std::vector<Point2> plane;
  std::vector<Point3> space;
  for (int i = 0; i < 20'000; ++i) {
    plane.push_back({uniform(random), uniform(random)});
    space.push_back({uniform(random), uniform(random), uniform(random)});
  }
  const auto in_plane = k::brio_order(plane, 1), in_space = k::brio_order(space, 1);
  CHECK(is_permutation_of_indices(in_plane, plane.size()));
  CHECK(is_permutation_of_indices(in_space, space.size()));
  // 2^15 > 20 000: at most 16 rounds, the smallest of them maybe empty.
  CHECK(falls(in_plane, k::hilbert_order(plane)) <= 15);
  CHECK(falls(in_plane, k::hilbert_order(plane)) >= 10);
  CHECK(falls(in_space, k::hilbert_order(space)) <= 15);
  // A round of m points makes a tour of length about sqrt(m): a geometric series, 1 / (1 - sqrt(1/2)) = 3.4 times the
  // length of its last term, which is sqrt(1/2) of the whole curve's.
  CHECK(tour_length(plane, in_plane) < 2.8 * tour_length(plane, k::hilbert_order(plane)));
}

TEST_CASE("the_last_round_of_brio_order_is_half_of_the_points_drawn_evenly") {
  Random random(102);
  std::vector<Point2> points;
  for (int i = 0; i < 40'000; ++i) points.push_back({uniform(random), uniform(random)});
  const auto order = k::brio_order(points, 7), curve = k::hilbert_order(points);
  std::vector<std::size_t> place(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) place[curve[i]] = i;
  std::size_t last_round = order.size() - 1;
  while (last_round > 0 && place[order[last_round - 1]] < place[order[last_round]]) --last_round;
  const auto half = static_cast<double>(order.size() - last_round);
  CHECK(std::abs(half - 20'000) < 500);  // five standard deviations of 100
  const auto right = std::count_if(order.begin() + static_cast<std::ptrdiff_t>(last_round), order.end(),
                                   [&](std::uint32_t i) { return points[i].x > 0; });
  CHECK(std::abs(static_cast<double>(right) - half / 2) < 600);
}

TEST_CASE("brio_order_follows_its_seed") {
  Random random(103);
  std::vector<Point3> points;
  for (int i = 0; i < 1000; ++i) points.push_back({uniform(random), uniform(random), uniform(random)});
  CHECK(k::brio_order(points, 5) == k::brio_order(points, 5));
  CHECK(k::brio_order(points, 5) != k::brio_order(points, 6));
  CHECK(k::brio_order(std::vector<Point3>{}, 5).empty());
  CHECK(k::brio_order(std::vector<Point2>{{1, 2}}, 5) == std::vector<std::uint32_t>{0});
}
