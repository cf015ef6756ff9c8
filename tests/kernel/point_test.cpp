// SPDX-License-Identifier: MIT
#include "leonhard/kernel/point.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <sstream>
#include <type_traits>
#include <unordered_set>

using namespace leonhard;

namespace {

template <class T>
std::string written(const T& value) {
  std::ostringstream out;
  out.precision(2);
  out << value;
  return out.str();
}

}  // namespace

TEST_CASE("differences_of_points_are_vectors_and_points_move_by_vectors") {
  static_assert(std::is_same_v<decltype(Point2{} - Point2{}), Vec2>);
  static_assert(std::is_same_v<decltype(Point3{} - Vec3{}), Point3>);
  constexpr Point2 p{1, 2};
  constexpr Vec2 v{0.5, -4};
  static_assert(p + v - v == p && (p + v) - p == v && p - v == p + -v);
  constexpr Point3 q{1, 2, 3};
  constexpr Vec3 w{0.5, -4, 8};
  static_assert(q + w - w == q && (q + w) - q == w && q - w == q + -w);
}

TEST_CASE("vectors_are_scaled_from_either_side_and_divided") {
  static_assert(2 * Vec2{1, -3} == Vec2{2, -6} && Vec2{1, -3} * 2 == Vec2{2, -6} &&
                Vec2{2, -6} / 2 == Vec2{1, -3});
  static_assert(2 * Vec3{1, -3, 5} == Vec3{2, -6, 10} && Vec3{1, -3, 5} * 2 == Vec3{2, -6, 10} &&
                Vec3{2, -6, 10} / 2 == Vec3{1, -3, 5});
}

TEST_CASE("assigning_operators_do_what_the_others_return") {
  Point2 p{1, 2};
  CHECK(((p += {3, 4}) == Point2{4, 6}));
  CHECK(((p -= {1, 1}) == Point2{3, 5}));
  Vec2 v{1, 2};
  CHECK(((v += {3, 4}) == Vec2{4, 6}));
  CHECK(((v -= {1, 2}) == Vec2{3, 4}));
  CHECK(((v *= 2) == Vec2{6, 8}));
  CHECK(((v /= 4) == Vec2{1.5, 2}));
  Point3 q{1, 2, 3};
  CHECK(((q += {3, 4, 5}) == Point3{4, 6, 8}));
  CHECK(((q -= {1, 1, 2}) == Point3{3, 5, 6}));
  Vec3 w{1, 2, 3};
  CHECK(((w += {3, 4, 5}) == Vec3{4, 6, 8}));
  CHECK(((w -= {1, 2, 3}) == Vec3{3, 4, 5}));
  CHECK(((w *= 2) == Vec3{6, 8, 10}));
  CHECK(((w /= 4) == Vec3{1.5, 2, 2.5}));
}

TEST_CASE("points_are_written_with_all_their_bits") {
  CHECK(written(Point2{0.5, 1}) == "(0.5, 1)");
  CHECK(written(Point2{0.1, 1.0 / 3}) == "(0.1, 0.3333333333333333)");
  CHECK(written(Vec2{-0.0, 1e300}) == "(-0, 1e+300)");
  CHECK(written(Point3{1, 2, std::numeric_limits<double>::denorm_min()}) == "(1, 2, 5e-324)");
  CHECK(written(Vec3{std::numeric_limits<double>::infinity(), 0, 7}) == "(inf, 0, 7)");
}

TEST_CASE("equal_points_have_one_hash_and_swapped_coordinates_another") {
  std::unordered_set<Point2> plane{{0.0, 1}, {-0.0, 1}, {1, 0}, {1, -0.0}, {2, 2}};
  CHECK(plane.size() == 3);
  CHECK(plane.contains({0, 1}));
  CHECK(std::hash<Point2>()({0, 1}) != std::hash<Point2>()({1, 0}));
  std::unordered_set<Point3> space{{0.0, 1, 2}, {-0.0, 1, 2}, {2, 1, 0}, {2, 1, -0.0}};
  CHECK(space.size() == 2);
  CHECK(std::hash<Point3>()({0, 1, 2}) != std::hash<Point3>()({0, 2, 1}));
}
