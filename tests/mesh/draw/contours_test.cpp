// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/plane/contours.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "leonhard/mesh/draw/canvas/levels.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

const PlotFrame hundredfold{{0, 0, 100, 100}, {0, 1}, {0, 1}};

double area_of(const std::vector<Point2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return std::abs(sum) / 2;
}

double length_of(const std::vector<Point2>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

}  // namespace

TEST_CASE("contour_of_x_is_one_straight_line_across_the_square") {
  const TriangleMesh mesh = test::unit_square(10);
  const MeshScene scene(mesh, hundredfold);
  const auto lines = contour(scene, test::values_on(mesh, [](Point2 p) { return p.x; }), 0.43);
  REQUIRE(lines.size() == 1);
  for (const Point2 p : lines[0]) CHECK(p.x == doctest::Approx(43));
  CHECK(length_of(lines[0]) == doctest::Approx(100));
}

TEST_CASE("contour_through_vertices_is_still_one_line") {
  const TriangleMesh mesh = test::unit_square(10);
  const MeshScene scene(mesh, hundredfold);
  const auto lines = contour(scene, test::values_on(mesh, [](Point2 p) { return p.x; }), 0.5);
  REQUIRE(lines.size() == 1);
  CHECK(length_of(lines[0]) == doctest::Approx(100));
}

TEST_CASE("contour_of_a_hill_is_one_closed_ring") {
  const TriangleMesh mesh = test::unit_square(50);
  const MeshScene scene(mesh, hundredfold);
  const auto lines =
      contour(scene, test::values_on(mesh, [](Point2 p) { return std::hypot(p.x - 0.5, p.y - 0.5); }), 0.3);
  REQUIRE(lines.size() == 1);
  CHECK(distance(lines[0].front(), lines[0].back()) < 1e-9);
  CHECK(length_of(lines[0]) == doctest::Approx(2 * std::numbers::pi * 30).epsilon(0.01));
}

TEST_CASE("levels_beyond_the_values_have_no_contour") {
  const TriangleMesh mesh = test::unit_square(4);
  const MeshScene scene(mesh, hundredfold);
  const auto values = test::values_on(mesh, [](Point2 p) { return p.y; });
  CHECK(contour(scene, values, -0.1).empty());
  CHECK(contour(scene, values, 1.1).empty());
}

TEST_CASE("bands_of_a_triangle_tile_it") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 10);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 200; ++round) {
    const auto point = [&] { return Point2{number(random), number(random)}; };
    const std::array<Point2, 3> corners{point(), point(), point()};
    // Whole numbers, so that corners often lie on a level.
    const auto value = [&] { return std::floor(number(random) / 2); };
    const std::array<double, 3> values{value(), value(), value()};
    double sum = 0;
    for (int level = -1; level < 6; ++level) {
      const double low = level < 0 ? -infinity : level, high = level == 5 ? infinity : level + 1;
      // A constant triangle on a level lies in both bands; it has no share that a picture could count on.
      if (values[0] == values[1] && values[1] == values[2]) continue;
      sum += area_of(band_of(corners, values, low, high));
    }
    if (values[0] != values[1] || values[1] != values[2]) {
      CHECK(sum == doctest::Approx(area_of({corners.begin(), corners.end()})));
    }
  }
}

TEST_CASE("bands_reach_out_to_whole_steps_with_nice_levels") {
  FieldOptions options;
  options.bands = 10;
  const Bands bands = make_bands({0.013, 0.987}, options);
  CHECK(bands.range == Range{0, 1});
  REQUIRE(bands.levels.size() == 9);
  CHECK(bands.levels[2] == 0.3);
  CHECK(bands.colours.size() == 10);
  CHECK_FALSE(bands.open_below);
  CHECK_FALSE(bands.open_above);
  CHECK(bands.index_of(-5) == 0);
  CHECK(bands.index_of(0.3) == 3);  // a level belongs to the band above
  CHECK(bands.index_of(5) == 9);
}

TEST_CASE("a_range_that_is_asked_for_is_kept_and_says_what_it_cuts") {
  FieldOptions options;
  options.value_range = Range{0.25, 0.75};
  const Bands bands = make_bands({0, 0.7}, options);
  CHECK(bands.range == Range{0.25, 0.75});
  CHECK(bands.open_below);
  CHECK_FALSE(bands.open_above);
}

TEST_CASE("levels_between_nice_values_make_these_the_middles_of_bands") {
  FieldOptions options;
  options.bands = 10;
  const Bands bands = make_bands({0.013, 0.987}, options, LevelPlace::between_nice_values);
  CHECK(bands.range.low == doctest::Approx(-0.05));
  CHECK(bands.range.high == doctest::Approx(1.05));
  REQUIRE(bands.levels.size() == 10);
  CHECK(bands.levels[0] == 0.05);
  CHECK(bands.levels[9] == 0.95);
}

TEST_CASE("a_constant_up_to_rounding_is_one_band") {
  const Bands bands = make_bands({0.8, 0.8 + 1e-15}, {});
  CHECK(bands.levels.empty());
  CHECK(bands.colours.size() == 1);
  CHECK(make_bands({0, 0}, {}).colours.size() == 1);
}

TEST_CASE("given_levels_are_used_as_they_are") {
  FieldOptions options;
  options.levels = {-1, 0.1, 0.5, 0.55, 3};
  const Bands bands = make_bands({0, 1}, options);
  CHECK(bands.levels == std::vector<double>{0.1, 0.5, 0.55});
  REQUIRE(bands.labels.size() == 3);
  CHECK(bands.labels[2].value == 0.55);
}
