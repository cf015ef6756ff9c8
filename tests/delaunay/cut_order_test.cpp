// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/order/cut_order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/delaunay/shapes.hpp"

namespace leonhard {
namespace {

using delaunay::CutOrder;
using delaunay::sort_by_cuts;

std::vector<shapes::NamedPoints> sets() {
  std::vector<shapes::NamedPoints> all = shapes::families();
  all.push_back({"none", {}});
  all.push_back({"one", {{3, 4}}});
  all.push_back({"many uniform", shapes::uniform(20'000)});
  // A quadtree would need a thousand levels for these.
  std::vector<Point2> powers{{0, 0}};
  for (int i = -1000; i < 1000; ++i) powers.push_back({std::ldexp(1.0, i), std::ldexp(1.0, i / 2)});
  all.push_back({"powers of two", powers});
  std::vector<Point2> repeated;
  for (int i = 0; i < 3000; ++i) repeated.push_back({static_cast<double>(i % 7), static_cast<double>(i % 3)});
  all.push_back({"few places", repeated});
  // No grid divides these. Each is there twice, from odd positions on: cuts between the two once took all high ones.
  std::vector<Point2> subnormal_twice{{0, 0}};
  for (int i = 0; i < 20'000; ++i)
    subnormal_twice.push_back({(1 + i / 2) * 0x1p-1074, (i / 2 * 7919 % 10'007) * 0x1p-1074});
  all.push_back({"subnormal, twice", subnormal_twice});
  std::vector<Point2> dense = shapes::transformed(shapes::uniform(10'000, 5), 1e-12, 1);
  dense.push_back({0, 0});
  all.push_back({"dense and far", dense});
  return all;
}

/// The points [first, last) are separated by their highest cut, and so on within its two sides.
void require_separated(const CutOrder& order, std::size_t first, std::size_t last) {
  if (last - first < 2) return;
  const auto depth = order.cut_depth.begin(), cut = std::min_element(depth + first + 1, depth + last);
  const auto middle = static_cast<std::size_t>(cut - depth);
  // One cut is the highest, so that the tree of cuts is no deeper than their depth.
  REQUIRE(std::count(depth + first + 1, depth + last, *cut) == 1);
  const bool by_x = *cut % 2 == 0;
  const auto less = [&](Point2 p, Point2 q) {
    return by_x ? p.x < q.x || (p.x == q.x && p.y < q.y) : p.y < q.y || (p.y == q.y && p.x > q.x);
  };
  const auto points = order.sorted.points.begin();
  const Point2 greatest = *std::max_element(points + first, points + middle, less),
               least = *std::min_element(points + middle, points + last, less);
  REQUIRE(less(greatest, least));
  require_separated(order, first, middle);
  require_separated(order, middle, last);
}

TEST_CASE("every_cut_separates_the_points_before_it_from_those_after_it") {
  for (const auto& [label, points] : sets()) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const CutOrder order = *sort_by_cuts(points, 1, {});
    REQUIRE(order.cut_depth.size() == order.sorted.points.size());
    require_separated(order, 0, order.sorted.points.size());
  }
}

TEST_CASE("the_cut_order_holds_each_place_once_and_knows_who_was_there") {
  for (const auto& [label, points] : sets()) {
    const auto& name = label;  // clang 14 captures no binding
    CAPTURE(name);
    const delaunay::SortedPoints sorted = sort_by_cuts(points, 1, {})->sorted;
    std::vector<Point2> distinct = points, found = sorted.points;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    std::sort(found.begin(), found.end());
    REQUIRE(found == distinct);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t at = sorted.sorted_index[i];
      REQUIRE(sorted.points[at] == points[i]);
      REQUIRE(sorted.first_input[at] <= i);
      REQUIRE(points[sorted.first_input[at]] == points[i]);
    }
  }
}

TEST_CASE("the_cut_order_does_not_depend_on_the_threads") {
  const std::vector<Point2> points = shapes::uniform(200'000);
  const CutOrder one = *sort_by_cuts(points, 1, {});
  for (const unsigned threads : {2U, 5U}) {
    const CutOrder several = *sort_by_cuts(points, threads, {});
    CHECK(several.sorted.points == one.sorted.points);
    CHECK(several.sorted.first_input == one.sorted.first_input);
    CHECK(several.cut_depth == one.cut_depth);
  }
}

TEST_CASE("a_stop_request_ends_the_sort") {
  std::stop_source source;
  source.request_stop();
  Progress progress;
  progress.stop = source.get_token();
  CHECK_FALSE(sort_by_cuts(shapes::uniform(50'000), 1, progress).has_value());
}

}  // namespace
}  // namespace leonhard
