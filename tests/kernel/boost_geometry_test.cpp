// SPDX-License-Identifier: MIT
#include "leonhard/kernel/boost_geometry.hpp"

#include <doctest/doctest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>
#include <vector>

#include "tests/kernel/point_families.hpp"

namespace bg = boost::geometry;
using leonhard::Box2;
using leonhard::Point2;
using leonhard::Segment2;

TEST_CASE("boost_geometry_measures_polygons_of_our_points") {
  bg::model::polygon<Point2, false> triangle;
  triangle.outer() = {{0, 0}, {4, 0}, {0, 3}, {0, 0}};
  CHECK(bg::area(triangle) == doctest::Approx(6));
  CHECK(bg::within(Point2{1, 1}, triangle));
  CHECK(!bg::within(Point2{3, 3}, triangle));
  CHECK(bg::distance(Point2{2, -1}, Segment2{{0, 0}, {4, 0}}) == doctest::Approx(1));
}

TEST_CASE("boost_rtree_of_our_points_answers_box_and_nearest_queries") {
  using Entry = std::pair<Point2, std::size_t>;
  leonhard::testing::Random random(71);
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < 500; ++i)
    entries.push_back({{leonhard::testing::uniform(random), leonhard::testing::uniform(random)}, i});
  const bg::index::rtree<Entry, bg::index::rstar<16>> tree(entries);

  const Box2 box{{-0.25, -0.5}, {0.5, 0.25}};
  std::vector<Entry> found, nearest;
  tree.query(bg::index::within(box), std::back_inserter(found));
  std::size_t expected = 0, closest = 0;
  for (const auto& [p, i] : entries) {
    expected += p.x > -0.25 && p.x < 0.5 && p.y > -0.5 && p.y < 0.25;
    if (leonhard::distance(p, {0, 0}) < leonhard::distance(entries[closest].first, {0, 0})) closest = i;
  }
  CHECK(found.size() == expected);
  tree.query(bg::index::nearest(Point2{0, 0}, 1), std::back_inserter(nearest));
  REQUIRE(nearest.size() == 1);
  CHECK(nearest[0].second == closest);
}
