// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/curves.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

constexpr Colour red{1, 0, 0};
constexpr std::uint32_t red_word = 0xFFFF0000U;

Curve curve(std::vector<double> x, std::vector<double> y) {
  return {.name = "", .x = std::move(x), .y = std::move(y), .colour = red};
}

test::Pixels drawn(const Curve& one, const AxesOptions& axes) {
  const test::Folder folder;
  draw_curves(folder / "curve.png", std::span(&one, 1), axes);
  return test::Pixels(folder / "curve.png");
}

AxesOptions unit_axes() { return {.x_range = Range{0, 1}, .y_range = Range{0, 1}}; }

}  // namespace

TEST_CASE("a_curve_from_corner_to_corner_fills_the_frame") {
  const test::Pixels picture = drawn(curve({0, 1}, {0, 1}), unit_axes());
  // The frame is the one dark box; all else dark are letters outside it.
  const auto [left, top, right, bottom] = picture.box_of(red_word);
  CHECK(left > 40);
  CHECK(left < 160);
  CHECK(top > 20);
  CHECK(right < 1590);
  CHECK(right > 1500);
  CHECK(bottom < 980);
  CHECK(bottom > 850);
  // Rising to the right: the left end is the low end.
  int at_left = 0;
  for (int y = 0; y < picture.height; ++y) {
    if (picture.at(left, y) == red_word) at_left = y;
  }
  CHECK(at_left > bottom - 20);
}

TEST_CASE("an_inverted_axis_puts_low_values_at_the_top") {
  AxesOptions axes = unit_axes();
  axes.invert_y = true;
  const test::Pixels picture = drawn(curve({0, 1}, {0, 1}), axes);
  const auto [left, top, right, bottom] = picture.box_of(red_word);
  int at_left = 0;
  for (int y = 0; y < picture.height; ++y) {
    if (picture.at(left, y) == red_word) at_left = y;
  }
  CHECK(at_left < top + 20);
}

TEST_CASE("a_power_law_is_straight_on_logarithmic_axes") {
  AxesOptions axes{.log_x = true, .log_y = true, .x_range = Range{1, 100}, .y_range = Range{1e-4, 1}};
  const test::Pixels picture = drawn(curve({1, 10, 100}, {1e-4, 1e-2, 1}), axes);
  const auto [left, top, right, bottom] = picture.box_of(red_word);
  // The middle of the frame lies on the curve.
  bool hit = false;
  for (int d = -2; d <= 2; ++d)
    hit = hit || test::difference(picture.at((left + right) / 2, (top + bottom) / 2 + d), red_word) < 100;
  CHECK(hit);
}

TEST_CASE("points_that_cannot_be_drawn_interrupt_the_line") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const test::Pixels whole = drawn(curve({0, 0.25, 0.5, 0.75, 1}, {0.5, 0.5, 0.5, 0.5, 0.5}), unit_axes());
  const test::Pixels broken = drawn(curve({0, 0.25, 0.5, 0.75, 1}, {0.5, 0.5, nan, 0.5, 0.5}), unit_axes());
  const double share =
      static_cast<double>(broken.count(red_word)) / static_cast<double>(whole.count(red_word));
  CHECK(share == doctest::Approx(0.5).epsilon(0.05));
  AxesOptions log = unit_axes();
  log.log_y = true;
  log.y_range = Range{0.1, 1};
  CHECK(drawn(curve({0, 0.25, 0.5, 0.75, 1}, {0.5, 0.5, 0, -1, 0.5}), log).count(red_word) > 0);
}

TEST_CASE("points_outside_the_range_stay_outside_the_frame") {
  const test::Pixels picture = drawn(curve({-1e300, 0.5, 1e300}, {0.5, 0.5, 0.5}), unit_axes());
  const auto [left, top, right, bottom] = picture.box_of(red_word);
  CHECK(left > 40);
  CHECK(right < 1590);
  CHECK(bottom - top < 5);
}

TEST_CASE("a_constant_and_a_single_point_can_be_drawn") {
  CHECK(drawn(curve({1, 2, 3}, {7, 7, 7}), {}).count(red_word) > 100);
  CHECK(drawn(curve({1, 2, 3}, {0, 0, 0}), {}).count(red_word) > 100);
  Curve one = curve({1}, {1});
  one.marker = MarkerStyle::square;
  CHECK(drawn(one, {.log_y = true}).count(red_word) > 5);
}

TEST_CASE("a_legend_keeps_away_from_the_curves") {
  const test::Folder folder;
  std::vector<Curve> curves{curve({0, 0.6, 0.61, 1}, {1, 1, 0, 0}),
                            curve({0, 0.6, 0.61, 1}, {0.95, 0.95, 0, 0})};
  const AxesOptions without{.legend = LegendPlace::none};
  draw_curves(folder / "without.png", curves, without);
  curves[0].name = "one";
  curves[1].name = "another";
  draw_curves(folder / "with.png", curves, {});
  const auto count = [&](const char* name) { return test::Pixels(folder / name).count(red_word); };
  // The legend adds samples of the lines and hides nothing of the curves.
  CHECK(count("with.png") > count("without.png"));
}

TEST_CASE("panels_stand_below_one_another") {
  const test::Folder folder;
  const CurvePanel panel{{curve({0, 1}, {0.5, 0.5})}, unit_axes()};
  const std::vector<CurvePanel> panels(3, panel);
  draw_panels(folder / "panels.png", panels, "Three", 1);
  const test::Pixels picture(folder / "panels.png");
  std::vector<int> rows;
  for (int y = 0; y < picture.height; ++y) {
    if (picture.at(800, y) == red_word && (rows.empty() || y > rows.back() + 5)) rows.push_back(y);
  }
  REQUIRE(rows.size() == 3);
  CHECK(std::abs((rows[2] - rows[1]) - (rows[1] - rows[0])) <= 1);
}

TEST_CASE("histogram_bars_are_as_high_as_their_counts") {
  const test::Folder folder;
  const std::vector<double> edges{0, 10, 20, 30}, counts{4, 0, 2};
  draw_histogram(folder / "bars.png", edges, counts, {});
  const test::Pixels picture(folder / "bars.png");
  const std::uint32_t bar = packed(line_colour(0));
  const auto box = picture.box_of(bar);
  const auto height_at = [&](double x) {
    int height = 0;
    for (int y = 0; y < picture.height; ++y) {
      height += picture.at(box[0] + static_cast<int>(x * (box[2] - box[0])), y) == bar ? 1 : 0;
    }
    return height;
  };
  CHECK(height_at(1.0 / 6) > 500);
  CHECK(height_at(3.0 / 6) == 0);
  CHECK(std::abs(2 * height_at(5.0 / 6) - height_at(1.0 / 6)) <= 3);
}
