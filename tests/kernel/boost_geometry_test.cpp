// SPDX-License-Identifier: MIT
#include "leonhard/kernel/boost_geometry.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/algorithms/is_convex.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>
#include <vector>

#include "leonhard/kernel/stages/exact.hpp"
#include "tests/kernel/point_families.hpp"

namespace bg = boost::geometry;
namespace exact = leonhard::kernel::exact;
using leonhard::Box2;
using leonhard::Box3;
using leonhard::Point2;
using leonhard::Point3;
using leonhard::Segment2;
using leonhard::Segment3;
using leonhard::Sign;
using leonhard::kernel::ExactSide;
using leonhard::kernel::ExactWinding;

namespace {

using Ring = bg::model::ring<Point2, false>;  // counter-clockwise, closed

Ring triangle(Point2 a, Point2 b, Point2 c) { return {a, b, c, a}; }

Ring scaled(double factor, Ring ring) {
  for (Point2& p : ring) p = {factor * p.x, factor * p.y};
  return ring;
}

/// The least of the three exact sides: positive inside the counter-clockwise triangle, zero on its edges.
Sign exact_place(Point2 p, Point2 a, Point2 b, Point2 c) {
  return std::min({exact::orient2d(a, b, p), exact::orient2d(b, c, p), exact::orient2d(c, a, p)});
}

}  // namespace

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

TEST_CASE("boost_geometry_measures_in_space") {
  CHECK(bg::distance(Point3{1, 2, 2}, Point3{0, 0, 0}) == doctest::Approx(3));
  CHECK(bg::distance(Point3{2, 3, 4}, Segment3{{0, 0, 0}, {4, 0, 0}}) == doctest::Approx(5));
  CHECK(bg::length(Segment3{{0, 0, 0}, {2, 3, 6}}) == doctest::Approx(7));
  Box3 box;
  bg::envelope(Segment3{{1, 0, 5}, {0, 2, 4}}, box);
  CHECK(box.min_corner() == Point3{0, 0, 4});
  CHECK(box.max_corner() == Point3{1, 2, 5});
}

TEST_CASE("boost_rtree_of_our_space_points_answers_box_queries") {
  leonhard::testing::Random random(72);
  std::vector<Point3> points(500), found;
  for (Point3& p : points)
    p = {leonhard::testing::uniform(random), leonhard::testing::uniform(random),
         leonhard::testing::uniform(random)};
  const bg::index::rtree<Point3, bg::index::rstar<16>> tree(points);
  const Box3 box{{-0.25, -0.5, -0.75}, {0.5, 0.25, 0.75}};
  tree.query(bg::index::within(box), std::back_inserter(found));
  const auto is_inside = [](const Point3& p) {
    return p.x > -0.25 && p.x < 0.5 && p.y > -0.5 && p.y < 0.25 && p.z > -0.75 && p.z < 0.75;
  };
  CHECK(std::ptrdiff_t(found.size()) == std::ranges::count_if(points, is_inside));
  CHECK(std::ranges::all_of(found, is_inside));
}

TEST_CASE("exact_winding_is_right_one_step_off_an_edge_where_boosts_default_is_wrong") {
  const Point2 a{0, 0}, b{1, 0.1}, c{0, 1};
  const Point2 p{0.5, std::nextafter(0.05, 0)};  // 0.05 is half of 0.1 to the last bit, so p lies below ab
  REQUIRE(exact::orient2d(a, b, p) == Sign::negative);
  CHECK(bg::covered_by(p, triangle(a, b, c)));
  CHECK_FALSE(bg::covered_by(p, triangle(a, b, c), ExactWinding{}));

  const Point2 q{0.5, std::nextafter(0.05, 1)};
  REQUIRE(exact_place(q, a, b, c) == Sign::positive);
  CHECK_FALSE(bg::within(q, triangle(a, b, c)));
  CHECK(bg::within(q, triangle(a, b, c), ExactWinding{}));
}

TEST_CASE("exact_winding_does_not_depend_on_the_unit_of_length_as_boosts_default_does") {
  const Ring unit = triangle({0, 0}, {4, 0}, {0, 3});
  for (const double factor : {0x1p-1074, 0x1p-600, 0x1p-30, 1.0, 0x1p600, 0x1p1020}) {
    CAPTURE(factor);
    const Ring ring = scaled(factor, unit);
    const Point2 inside{factor, factor}, outside{2 * factor, 2 * factor}, on_edge{0, factor};
    CHECK(bg::within(inside, ring, ExactWinding{}));
    CHECK_FALSE(bg::covered_by(outside, ring, ExactWinding{}));
    CHECK(bg::covered_by(on_edge, ring, ExactWinding{}));
    CHECK_FALSE(bg::within(on_edge, ring, ExactWinding{}));
  }
  for (const double factor : {0x1p-30, 0x1p600}) {
    CAPTURE(factor);
    CHECK(bg::covered_by(Point2{2 * factor, 2 * factor}, scaled(factor, unit)));
  }
}

TEST_CASE("exact_side_sees_the_dent_that_boosts_default_takes_for_straight") {
  const Point2 dent{0.5, std::nextafter(0.05, 1)};
  const Ring ring{{0, 0}, dent, {1, 0.1}, {0, 1}, {0, 0}};
  REQUIRE(exact::orient2d({0, 0}, dent, {1, 0.1}) == Sign::negative);
  CHECK(bg::is_convex(ring));
  CHECK_FALSE(bg::is_convex(ring, ExactSide{}));
  CHECK(bg::is_convex(scaled(0x1p-600, triangle({0, 0}, {4, 0}, {0, 3})), ExactSide{}));
}

TEST_CASE("exact_winding_agrees_with_rational_signs_of_triangles") {
  leonhard::testing::Random random(73);
  for (const auto& family : leonhard::testing::point_families()) {
    CAPTURE(family.name);
    for (int i = 0; i < 2000; ++i) {
      auto [a, b, c, p] = family.draw(random);
      const Sign turn = exact::orient2d(a, b, c);
      if (turn == Sign::zero) continue;
      if (turn == Sign::negative) std::swap(b, c);
      const Sign place = exact_place(p, a, b, c);
      for (const Ring& ring : {triangle(a, b, c), triangle(a, c, b)}) {
        REQUIRE(bg::within(p, ring, ExactWinding{}) == (place == Sign::positive));
        REQUIRE(bg::covered_by(p, ring, ExactWinding{}) == (place != Sign::negative));
      }
    }
  }
}

TEST_CASE("exact_winding_counts_rays_through_corners_once") {
  Ring diamond{{2, 0}, {0, 2}, {-2, 0}, {0, -2}, {2, 0}};
  CHECK(bg::within(Point2{0, 0}, diamond, ExactWinding{}));
  CHECK_FALSE(bg::covered_by(Point2{-3, 0}, diamond, ExactWinding{}));
  CHECK_FALSE(bg::covered_by(Point2{-1, 2}, diamond, ExactWinding{}));
  CHECK_FALSE(bg::covered_by(Point2{-1, -2}, diamond, ExactWinding{}));
  bg::model::polygon<Point2, false> with_hole;
  with_hole.outer() = scaled(2, diamond);
  with_hole.inners() = {Ring(diamond.rbegin(), diamond.rend())};
  CHECK_FALSE(bg::covered_by(Point2{0, 0}, with_hole, ExactWinding{}));
  CHECK(bg::within(Point2{-3, 0}, with_hole, ExactWinding{}));
  CHECK(bg::covered_by(Point2{2, 0}, with_hole, ExactWinding{}));
}

TEST_CASE("exact_winding_finds_points_on_segments") {
  const Segment2 level{{0, 1}, {4, 1}};
  CHECK(bg::within(Point2{2, 1}, level, ExactWinding{}));
  CHECK(bg::covered_by(Point2{4, 1}, level, ExactWinding{}));
  CHECK_FALSE(bg::within(Point2{4, 1}, level, ExactWinding{}));
  CHECK_FALSE(bg::covered_by(Point2{-1, 1}, level, ExactWinding{}));
  CHECK_FALSE(bg::covered_by(Point2{5, 1}, level, ExactWinding{}));
}
