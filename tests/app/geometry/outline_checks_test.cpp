// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/outline_checks.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/app/input_error_of.hpp"

using namespace leonhard;
using namespace leonhard::app;

namespace {

std::string refusal(std::vector<Point2> points) {
  return input_error_of([&] { return check_outline({"wing", "c.toml:3", points}), 0; });
}

bool has(const std::string& message, const std::string& part) {
  INFO("message: ", message);
  CHECK(message.find(part) != std::string::npos);
  return message.find(part) != std::string::npos;
}

/// A star-shaped polygon with rays of random length: long thin spikes, no self-crossing.
std::vector<Point2> star(unsigned seed, int n) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.01, 1);
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = radius(random);
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

const NamedOutline square{"main", "c.toml:1", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

NamedOutline moved(const NamedOutline& outline, const std::string& name, Vec2 by) {
  NamedOutline copy{name, "c.toml:9", outline.points};
  for (Point2& p : copy.points) p = p + by;
  return copy;
}

}  // namespace

TEST_CASE("simple_outlines_pass") {
  CHECK(refusal(square.points).empty());
  for (unsigned seed = 0; seed < 20; ++seed) CHECK(refusal(star(seed, 200)).empty());
}

TEST_CASE("an_outline_that_crosses_itself_names_both_edges_with_coordinates") {
  const std::string message = refusal({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  has(message,
      "c.toml:3: the outline of body \"wing\" crosses or touches itself: edge 1 from (0, 0) to (1, 1) meets "
      "edge 3 from (1, 0) to (0, 1)");
}

TEST_CASE("an_outline_that_touches_itself_by_a_hair_is_refused_and_one_that_misses_by_a_bit_passes") {
  const double above = std::nextafter(0.5, 1);
  has(refusal({{0, 0}, {1, 0}, {1, 1}, {0.5, 0}, {0, 1}}), "crosses or touches itself");
  CHECK(refusal({{0, 0}, {1, 0}, {1, 1}, {0.5, std::numeric_limits<double>::denorm_min()}, {0, 1}}).empty());
  CHECK(refusal({{0, 0}, {1, 1}, {0, 1}, {0.25, above}}).empty());
}

TEST_CASE("an_edge_that_folds_back_is_refused") {
  has(refusal({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), "crosses or touches itself");
  has(refusal({{0, 0}, {1, 0}, {2, 0}}), "crosses or touches itself");
}

TEST_CASE("points_given_twice_not_finite_or_too_few_are_named") {
  has(refusal({{0, 0}, {1, 0}, {1, 1}, {1, 0}}), "points 2 and 4 of body \"wing\" are the same, (1, 0)");
  has(refusal({{0, 0}, {1, 0}, {1, std::nan("")}}), "point 3 of body \"wing\" is (1, nan)");
  has(refusal({{0, 0}, {1, 0}}), "body \"wing\" has 2 points only");
}

TEST_CASE("bodies_that_cross_touch_or_contain_each_other_are_both_named") {
  const auto with = [](const NamedOutline& other) {
    const std::vector<NamedOutline> bodies{square, other};
    return input_error_of([&] { return check_apart(bodies), 0; });
  };
  CHECK(with(moved(square, "flap", {1.5, 0})).empty());
  CHECK(with(moved(square, "flap", {std::nextafter(1.0, 2), 0})).empty());
  has(with(moved(square, "flap", {0.5, 0.5})),
      "bodies \"main\" and \"flap\" overlap or touch: the edge from (");
  has(with(moved(square, "flap", {1, 0.5})), "overlap or touch");
  has(with(moved(square, "flap", {1, 1})), "overlap or touch");
  const NamedOutline inner{"flap", "c.toml:9", {{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}}};
  has(with(inner), "c.toml:9: body \"flap\" lies inside body \"main\": its point (0.4, 0.4) does");
}

TEST_CASE("bodies_beyond_the_far_field_and_far_fields_within_a_body_are_told_apart") {
  const std::vector<NamedOutline> bodies{square};
  const auto with = [&](double size, Vec2 by) {
    std::vector<Point2> circle;
    for (int i = 0; i < 12; ++i) {
      const double angle = 2 * std::numbers::pi * i / 12;
      circle.push_back(Point2{0.5, 0.5} + by + size * Vec2{std::cos(angle), std::sin(angle)});
    }
    return input_error_of([&] { return check_inside_far_field(bodies, circle, "c.toml"), 0; });
  };
  CHECK(with(2, {0, 0}).empty());
  has(with(0.5, {0, 0}), "c.toml: the far field is smaller than body \"main\"");
  has(with(2, {5, 0}), "c.toml: body \"main\" is not inside the far field: its point (0, 0) is out");
}

TEST_CASE("a_point_inside_is_strictly_inside_thin_and_spiky_polygons") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const std::vector<Point2> points = star(seed, 60);
    CHECK(locate_in_polygon(points, point_inside({"s", "", points})) == PointPlace::inside);
  }
  const std::vector<Point2> sliver{{0, 0}, {1, 0}, {0.5, 1e-15}};
  CHECK(locate_in_polygon(sliver, point_inside({"s", "", sliver})) == PointPlace::inside);
  const std::vector<Point2> crescent{{0, 0}, {1, 0.5}, {0, 1}, {0.999999, 0.5}};
  CHECK(locate_in_polygon(crescent, point_inside({"s", "", crescent})) == PointPlace::inside);
  const double bit = std::numeric_limits<double>::denorm_min();
  const std::vector<Point2> none{{0, 0}, {bit, 0}, {0, bit}};
  has(input_error_of([&] {
        return point_inside({"s", "c.toml:2", none});
      }),
      "c.toml:2: body \"s\" is too thin");
}

TEST_CASE("a_polygon's_corners_and_edges_are_its_boundary") {
  CHECK(locate_in_polygon(square.points, {1, 1}) == PointPlace::on_boundary);
  CHECK(locate_in_polygon(square.points, {1, 0.3}) == PointPlace::on_boundary);
  CHECK(locate_in_polygon(square.points, {std::nextafter(1.0, 2), 0.3}) == PointPlace::outside);
  CHECK(locate_in_polygon(square.points, {std::nextafter(1.0, 0), 0.3}) == PointPlace::inside);
  CHECK(locate_in_polygon(square.points, {-1, 0}) == PointPlace::outside);
  CHECK(locate_in_polygon(square.points, {2, 1}) == PointPlace::outside);
}

TEST_CASE("ten_thousand_points_are_checked_in_a_moment") {
  std::vector<Point2> circle;
  for (int i = 0; i < 10'000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 10'000;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  const auto start = std::chrono::steady_clock::now();
  check_outline({"disc", "", circle});
  (void)point_inside({"disc", "", circle});
  // Generous: it takes some milliseconds; a test of every pair would take minutes under a sanitizer.
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}
