// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/canvas/axes.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "leonhard/mesh/draw/plane/scene.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

std::vector<std::string> labels(const Axis& axis, int target) {
  std::vector<std::string> result;
  for (const Tick& tick : ticks_of(axis, target)) {
    if (!tick.label.empty()) result.push_back(tick.label);
  }
  return result;
}

}  // namespace

TEST_CASE("nice_step_is_the_nearest_of_1_2_25_5") {
  CHECK(nice_step(1) == 1);
  CHECK(nice_step(1.3) == 1);
  CHECK(nice_step(1.9) == 2);
  CHECK(nice_step(2.4) == 2.5);
  CHECK(nice_step(6) == 5);
  CHECK(nice_step(8) == 10);
  CHECK(nice_step(0.0031) == doctest::Approx(0.0025));
  CHECK(nice_step(3.9e7) == doctest::Approx(5e7));
}

TEST_CASE("multiples_are_the_doubles_nearest_to_their_decimals") {
  const auto tenths = multiples(0.1, -0.3, 1.0);
  REQUIRE(tenths.size() == 14);
  CHECK(tenths[0] == -0.3);
  CHECK(tenths[3] == 0.0);
  CHECK(tenths[6] == 0.3);  // 3 * 0.1 is not
  CHECK(tenths[13] == 1.0);
  CHECK(multiples(250, 100, 1000) == std::vector<double>{250, 500, 750, 1000});
  CHECK(multiples(0.025, 0.05, 0.1) == std::vector<double>{0.05, 0.075, 0.1});
}

TEST_CASE("labels_have_the_digits_that_the_step_needs_and_a_true_minus") {
  CHECK(labels({-1, 1}, 4) == std::vector<std::string>{"−1.0", "−0.5", "0.0", "0.5", "1.0"});
  CHECK(labels({0, 60}, 6) == std::vector<std::string>{"0", "10", "20", "30", "40", "50", "60"});
  CHECK(labels({0, 1}, 4) == std::vector<std::string>{"0.00", "0.25", "0.50", "0.75", "1.00"});
  CHECK(labels({0, 2e-5}, 2) == std::vector<std::string>{"0", "1×10⁻⁵", "2×10⁻⁵"});
  CHECK(labels({0, 1e7}, 2) == std::vector<std::string>{"0", "0.5×10⁷", "1.0×10⁷"});
}

TEST_CASE("logarithmic_axes_are_labelled_by_decades") {
  CHECK(labels({.low = 1e-4, .high = 1, .logarithmic = true}, 8) ==
        std::vector<std::string>{"10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰"});
  CHECK(labels({.low = 1e-10, .high = 1, .logarithmic = true}, 5) ==
        std::vector<std::string>{"10⁻¹⁰", "10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰"});
  CHECK(labels({.low = 0.15, .high = 0.6, .logarithmic = true}, 5) ==
        std::vector<std::string>{"2×10⁻¹", "5×10⁻¹"});
}

TEST_CASE("page_and_world_are_inverse_on_every_kind_of_axis") {
  const Rect area{100, 50, 800, 400};
  for (const bool logarithmic : {false, true}) {
    for (const bool reversed : {false, true}) {
      const Axis axis{0.5, 20, logarithmic, reversed};
      const PlotFrame frame{area, axis, axis};
      for (const Point2 p : {Point2{0.5, 0.5}, Point2{3, 19}, Point2{20, 0.7}}) {
        const Point2 q = frame.world(frame.page(p));
        CHECK(q.x == doctest::Approx(p.x));
        CHECK(q.y == doctest::Approx(p.y));
      }
    }
  }
  const PlotFrame up{area, {0, 1}, {0, 1}}, down{area, {0, 1}, {.low = 0, .high = 1, .reversed = true}};
  CHECK(up.page({0, 0}) == Point2{100, 450});  // low values at the bottom left
  CHECK(up.page({1, 1}) == Point2{900, 50});
  CHECK(down.page({0, 0}) == Point2{100, 50});
}

TEST_CASE("a_map_shows_all_of_its_region_with_one_scale_inside_the_page") {
  const test::Folder folder;
  for (const Box region : {Box{{0, 0}, {1, 1}}, Box{{-3, 5}, {40, 6}}, Box{{1e6, 1e6}, {1e6 + 1, 1e6 + 7}}}) {
    Canvas canvas(folder / "x.png", {});
    const PlotFrame frame =
        fit_map(canvas, {0, 0, canvas.width(), canvas.height()}, region, {"title", "x label", "y label"});
    CHECK(frame.area.left > 0);
    CHECK(frame.area.top > 0);
    CHECK(frame.area.right() < canvas.width());
    CHECK(frame.area.bottom() < canvas.height());
    CHECK(frame.x.low <= region.low.x);
    CHECK(frame.x.high >= region.high.x);
    CHECK(frame.y.low <= region.low.y);
    CHECK(frame.y.high >= region.high.y);
    CHECK((frame.x.high - frame.x.low) / frame.area.width ==
          doctest::Approx((frame.y.high - frame.y.low) / frame.area.height));
    const double filled_x = (region.high.x - region.low.x) / (frame.x.high - frame.x.low);
    const double filled_y = (region.high.y - region.low.y) / (frame.y.high - frame.y.low);
    CHECK(std::max(filled_x, filled_y) == doctest::Approx(1));  // no smaller than need be
  }
}
