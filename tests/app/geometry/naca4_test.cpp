// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/naca4.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "leonhard/app/geometry/outline_checks.hpp"
#include "tests/app/input_error_of.hpp"

using namespace leonhard;
using namespace leonhard::app;

namespace {

/// Area enclosed by the formula's outline, by a fine polygon.
double area(const std::string& digits, TrailingEdge trailing_edge) {
  const Naca4 section(digits, trailing_edge, "");
  std::vector<Point2> points;
  for (int i = 0; i <= 40'000; ++i) points.push_back(section.at(1 - i / 20'000.0));
  return rounded_area2(points) / 2;
}

}  // namespace

TEST_CASE("the_three_trailing_edges_enclose_their_known_areas") {
  // Integrals of the three formulas in closed form, e.g. open: 1.2 (0.2969 2/3 - 0.1260/2 - 0.3516/3 + 0.2843/4 - 0.1015/5).
  CHECK(area("0012", TrailingEdge::open) == doctest::Approx(0.082210).scale(0).epsilon(1e-5));
  CHECK(area("0012", TrailingEdge::closed) == doctest::Approx(0.081706).scale(0).epsilon(1e-5));
  CHECK(area("0012", TrailingEdge::sharp) == doctest::Approx(0.080772).scale(0).epsilon(1e-5));
}

TEST_CASE("the_sharp_section_is_the_turbulence_resource's_polynomial") {
  // NASA Turbulence Modeling Resource, naca0012_val: y(x) with the trailing edge closed by scaling.
  const auto published = [](double x) {
    return 0.594689181 * (0.298222773 * std::sqrt(x) - 0.127125232 * x - 0.357907906 * x * x +
                          0.291984971 * x * x * x - 0.105174606 * x * x * x * x);
  };
  const Naca4 section("0012", TrailingEdge::sharp, "");
  for (double x = 0; x <= 1; x += 1.0 / 64) CHECK(std::abs(section.half_thickness(x) - published(x)) < 1e-9);
}

TEST_CASE("sharp_and_closed_sections_end_in_one_point_and_open_ones_in_a_base") {
  for (const auto trailing_edge : {TrailingEdge::sharp, TrailingEdge::closed})
    for (const auto* digits : {"0012", "2412", "6409"}) {
      const Naca4 section(digits, trailing_edge, "");
      CHECK(section.at(1) == Point2{1, 0});
      CHECK(section.at(-1) == Point2{1, 0});
      CHECK(section.outline().pieces.size() == 1);
    }
  const Naca4 open("0012", TrailingEdge::open, "");
  CHECK(open.at(1).y == doctest::Approx(0.00126).scale(0));
  CHECK(open.outline().pieces.size() == 2);
}

TEST_CASE("a_cambered_section_lies_about_its_mean_line") {
  const Naca4 section("2412", TrailingEdge::open, "");
  const double s = std::sqrt(0.4);  // at the highest camber the mean line is level
  const Point2 upper = section.at(s), lower = section.at(-s);
  CHECK(upper.x == doctest::Approx(0.4).scale(0));
  CHECK(lower.x == doctest::Approx(0.4).scale(0));
  CHECK((upper.y + lower.y) / 2 == doctest::Approx(0.02).scale(0));
  CHECK((upper.y - lower.y) / 2 == doctest::Approx(section.half_thickness(0.4)).scale(0));
  CHECK(section.at(0) == Point2{0, 0});
}

TEST_CASE("a_symmetric_section_is_symmetric_to_the_bit") {
  const Naca4 section("0012", TrailingEdge::sharp, "");
  for (double s = 0; s <= 1; s += 1.0 / 32) {
    const Point2 upper = section.at(s), lower = section.at(-s);
    CHECK(upper.x == lower.x);
    CHECK(upper.y == -lower.y);
  }
}

TEST_CASE("digits_that_mean_no_section_are_refused") {
  for (const auto* digits : {"12", "00123", "001x", "0000", "2012", "0412"}) {
    const std::string message =
        input_error_of([&] { return Naca4(digits, TrailingEdge::sharp, "c.toml:4"); });
    INFO("digits: ", digits, ", message: ", message);
    CHECK(message.starts_with("c.toml:4: "));
    CHECK(message.find(digits) != std::string::npos);
  }
}
