// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/spacing.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "leonhard/app/geometry/naca4.hpp"

using namespace leonhard;
using namespace leonhard::app;

namespace {

struct EdgeFigures {
  double shortest, longest, worst_ratio, worst_turn_deg;  ///< turn: corners above 30 degrees left out
};

EdgeFigures figures(const std::vector<Point2>& points) {
  EdgeFigures f{1e300, 0, 0, 0};
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = points[i] - points[(i + n - 1) % n], out = points[(i + 1) % n] - points[i];
    const double ratio = norm(in) / norm(out);
    const double turn = std::abs(std::atan2(cross(in, out), dot(in, out))) * 180 / std::numbers::pi;
    f.shortest = std::min(f.shortest, norm(out));
    f.longest = std::max(f.longest, norm(out));
    f.worst_ratio = std::max({f.worst_ratio, ratio, 1 / ratio});
    if (turn < 30) f.worst_turn_deg = std::max(f.worst_turn_deg, turn);
  }
  return f;
}

double edge_at(const std::vector<Point2>& points, Point2 p) {
  const auto nearer = [p](Point2 a, Point2 b) { return distance(a, p) < distance(b, p); };
  const std::size_t i = static_cast<std::size_t>(std::ranges::min_element(points, nearer) - points.begin());
  CHECK(distance(points[i], p) < 1e-12);
  return distance(points[i], points[(i + 1) % points.size()]);
}

OutlineCurve naca(TrailingEdge trailing_edge, const std::string& digits = "0012") {
  return Naca4(digits, trailing_edge, "").outline();
}

}  // namespace

TEST_CASE("edges_are_as_long_as_asked_at_both_edges_and_between") {
  const OutlineSpacing spacing{.elsewhere = 0.01, .leading_edge = 0.0005, .trailing_edge = 0.002};
  const std::vector<Point2> points = distribute(naca(TrailingEdge::sharp), spacing);
  CHECK(edge_at(points, {0, 0}) == doctest::Approx(0.0005).scale(0).epsilon(0.15));
  CHECK(edge_at(points, {1, 0}) == doctest::Approx(0.002).scale(0).epsilon(0.15));
  CHECK(figures(points).longest == doctest::Approx(0.01).scale(0).epsilon(0.05));
}

TEST_CASE("edges_change_gradually_and_turn_little") {
  for (const std::string digits : {"0012", "0008", "2412", "6424"})
    for (const double fine : {0.0005, 0.002, 0.006}) {
      const OutlineSpacing spacing{.elsewhere = 0.01, .leading_edge = fine, .trailing_edge = fine};
      const EdgeFigures f = figures(distribute(naca(TrailingEdge::closed, digits), spacing));
      INFO("digits: ", digits, ", fine: ", fine);
      CHECK(f.worst_ratio < 1.2);
      CHECK(f.worst_turn_deg < 6);
      CHECK(f.longest < 0.0101);
    }
}

TEST_CASE("a_thin_base_is_one_edge_and_its_neighbours_grow_from_it") {
  const OutlineSpacing spacing{.elsewhere = 0.02, .leading_edge = 0.01, .trailing_edge = 0.01};
  const std::vector<Point2> points = distribute(naca(TrailingEdge::open), spacing);
  const EdgeFigures f = figures(points);
  CHECK(f.worst_ratio < 1.25);
  CHECK(std::ranges::count_if(points, [](Point2 p) { return std::abs(p.x - 1) < 1e-12; }) == 2);
}

TEST_CASE("a_symmetric_section_gets_symmetric_points") {
  const std::vector<Point2> points = distribute(
      naca(TrailingEdge::sharp), {.elsewhere = 0.006, .leading_edge = 0.002, .trailing_edge = 0.002});
  REQUIRE(points.size() % 2 == 0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point2 mirror = points[points.size() - i];
    CHECK(std::abs(points[i].x - mirror.x) < 1e-9);
    CHECK(std::abs(points[i].y + mirror.y) < 1e-9);
  }
}

TEST_CASE("points_lie_on_the_curve_and_corners_are_points") {
  const std::vector<Point2> square{{1, 0}, {1, 1}, {0, 1}, {0, 0}};
  const std::vector<Point2> points = distribute(
      spline_outline(square, false, 10), {.elsewhere = 0.1, .leading_edge = 0.1, .trailing_edge = 0.1});
  for (const Point2 corner : square) CHECK(std::ranges::count(points, corner) == 1);
  for (const Point2 p : points) CHECK((p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1));
  CHECK(points.size() == 40);
}

TEST_CASE("a_smooth_closed_curve_is_walked_once") {
  std::vector<Point2> circle;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * std::numbers::pi * i / 24;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  const OutlineSpacing spacing{.elsewhere = 0.05, .leading_edge = 0.05, .trailing_edge = 0.05};
  const std::vector<Point2> points = distribute(spline_outline(circle, false, {}), spacing);
  CHECK(static_cast<double>(points.size()) ==
        doctest::Approx(2 * std::numbers::pi / 0.05).scale(0).epsilon(0.02));
  CHECK(figures(points).worst_ratio < 1.2);
}

TEST_CASE("the_same_input_gives_the_same_points") {
  const OutlineSpacing spacing;
  CHECK(distribute(naca(TrailingEdge::sharp, "4412"), spacing) ==
        distribute(naca(TrailingEdge::sharp, "4412"), spacing));
}
