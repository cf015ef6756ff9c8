// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/curve.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "leonhard/app/geometry/naca4.hpp"

using namespace leonhard;
using namespace leonhard::app;

namespace {

std::vector<Point2> circle(int n) {
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

/// Cosine-spaced points of a section as a file would hold them.
std::vector<Point2> coarse_section(TrailingEdge trailing_edge, int a_side) {
  const Naca4 section("0012", trailing_edge, "");
  std::vector<Point2> points;
  for (int i = 0; i <= 2 * a_side; ++i)
    points.push_back(section.at(std::cos(std::numbers::pi * i / (2 * a_side))));
  if (trailing_edge != TrailingEdge::open) points.pop_back();
  return points;
}

bool contains(const OutlineCurve& curve, Point2 p) {
  for (const CurvePiece& piece : curve.pieces)
    for (const double t : piece.knots)
      if (piece.at(t) == p) return true;
  return false;
}

double largest_error_on_circle(int n) {
  const OutlineCurve curve = spline_outline(circle(n), false, {});
  const CurvePiece& piece = curve.pieces.at(0);
  double error = 0;
  for (int k = 0; k <= 4000; ++k) {
    const Point2 p = piece.at(piece.knots.back() * k / 4000);
    error = std::max(error, std::abs(std::hypot(p.x, p.y) - 1));
  }
  return error;
}

}  // namespace

TEST_CASE("the_spline_passes_through_every_point_to_the_bit") {
  const std::vector<Point2> points = coarse_section(TrailingEdge::sharp, 30);
  const OutlineCurve curve = spline_outline(points, false, {});
  for (const Point2 p : points) CHECK(contains(curve, p));
}

TEST_CASE("the_periodic_spline_converges_on_a_circle_with_fourth_order") {
  const double coarse = largest_error_on_circle(16), fine = largest_error_on_circle(32);
  CHECK(coarse < 1e-3);
  CHECK(std::log2(coarse / fine) > 3.7);
}

TEST_CASE("the_spline_of_a_sampled_section_stays_near_the_formula") {
  const Naca4 section("0012", TrailingEdge::sharp, "");
  const OutlineCurve curve = spline_outline(coarse_section(TrailingEdge::sharp, 40), false, {});
  REQUIRE(curve.pieces.size() == 1);
  const CurvePiece& piece = curve.pieces[0];
  for (int k = 0; k <= 2000; ++k) {
    const Point2 p = piece.at(piece.knots.back() * k / 2000);
    if (p.x < 0.01) continue;  // where the surface is steep, compare no heights
    CHECK(std::abs(std::abs(p.y) - section.half_thickness(std::clamp(p.x, 0.0, 1.0))) < 2e-5);
  }
}

TEST_CASE("corners_are_kept_where_the_outline_turns_sharply") {
  const OutlineCurve round = spline_outline(circle(20), false, {});
  CHECK(round.pieces.size() == 1);
  CHECK(round.smooth_start);
  const std::vector<Point2> diamond{{1, 0}, {0.5, 0.05}, {0, 0}, {0.5, -0.05}};
  CHECK(spline_outline(diamond, false, {}).pieces.size() ==
        2);  // both ends turn by 168 degrees; the sides by 11
  CHECK(spline_outline(diamond, false, 5).pieces.size() == 4);
}

TEST_CASE("a_coarse_round_nose_is_no_corner") {
  // As in old files: x = 0, 1.25 %, 2.5 % ... of NACA 0012; the polygon turns by 67 degrees at the nose.
  const std::vector<Point2> points{{1, 0.00126},      {0.5, 0.05294},  {0.2, 0.05738},     {0.05, 0.03555},
                                   {0.0125, 0.01894}, {0, 0},          {0.0125, -0.01894}, {0.05, -0.03555},
                                   {0.2, -0.05738},   {0.5, -0.05294}, {1, -0.00126}};
  const OutlineCurve curve = spline_outline(points, true, {});
  CHECK(curve.pieces.size() == 2);
  CHECK(curve.leading_edge == Point2{0, 0});
}

TEST_CASE("a_blunt_trailing_edge_stays_a_straight_piece") {
  const std::vector<Point2> points = coarse_section(TrailingEdge::open, 30);
  const OutlineCurve curve = spline_outline(points, true, {});
  REQUIRE(curve.pieces.size() == 2);
  const CurvePiece& base = curve.pieces[1];
  CHECK(base.at(base.knots.front()) == points.back());
  CHECK(base.at(base.knots.back()) == points.front());
  CHECK(base.at(0.5 * base.knots.back()).x == doctest::Approx(1).scale(0));
  CHECK(std::abs(curve.trailing_edge.y) < 1e-15);
}

TEST_CASE("placement_scales_then_rotates_then_translates") {
  const Placement placement{2, 90, {10, 0}};
  const Point2 p = placement({1, 0});
  CHECK(p.x == doctest::Approx(10).scale(0));
  CHECK(p.y == doctest::Approx(2).scale(0));
  const OutlineCurve placed = place(spline_outline(circle(20), false, {}), placement);
  CHECK(chord_length(placed) == doctest::Approx(4).scale(0).epsilon(1e-6));
}
