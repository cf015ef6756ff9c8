// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/colour.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace leonhard::draw;

TEST_CASE("lab_of_the_primaries_is_that_of_the_literature") {
  // Bruce Lindbloom's calculator, sRGB, D65, 2 degrees.
  const auto near = [](LabColour a, LabColour b) {
    return std::abs(a.lightness - b.lightness) < 0.02 && std::abs(a.a - b.a) < 0.02 &&
           std::abs(a.b - b.b) < 0.02;
  };
  CHECK(near(to_lab({1, 0, 0}), {53.2408, 80.0925, 67.2032}));
  CHECK(near(to_lab({0, 1, 0}), {87.7347, -86.1827, 83.1793}));
  CHECK(near(to_lab({0, 0, 1}), {32.2970, 79.1875, -107.8602}));
  CHECK(near(to_lab({1, 1, 1}), {100, 0, 0}));
  CHECK(near(to_lab({0, 0, 0}), {0, 0, 0}));
}

TEST_CASE("srgb_survives_the_way_through_lab") {
  for (int r = 0; r <= 5; ++r) {
    for (int g = 0; g <= 5; ++g) {
      for (int b = 0; b <= 5; ++b) {
        const Colour c{r / 5.0, g / 5.0, b / 5.0}, d = to_srgb(to_lab(c));
        CHECK(std::abs(c.red - d.red) + std::abs(c.green - d.green) + std::abs(c.blue - d.blue) < 2e-3);
      }
    }
  }
}

TEST_CASE("colours_that_srgb_lacks_lose_chroma_only") {
  const LabColour wanted{50, 0, -120}, got = to_lab(to_srgb(wanted));
  CHECK(got.lightness == doctest::Approx(50).epsilon(0.01));
  CHECK(std::abs(got.a) < 1);
  CHECK(got.b < -20);
  CHECK(got.b > -119);
}

TEST_CASE("sequential_and_grey_maps_rise_in_lightness_by_even_steps") {
  for (const ColourMap map : {ColourMap::sequential, ColourMap::grey}) {
    const auto shades = colours(map, 65);
    double least = 1e9, most = 0;
    for (std::size_t i = 1; i < shades.size(); ++i) {
      CHECK(to_lab(shades[i]).lightness > to_lab(shades[i - 1]).lightness);
      const double step = colour_distance(shades[i - 1], shades[i]);
      least = std::min(least, step);
      most = std::max(most, step);
    }
    CHECK(most / least < 1.2);
    CHECK(to_lab(shades.back()).lightness - to_lab(shades.front()).lightness > 75);
  }
}

TEST_CASE("diverging_map_is_even_and_symmetrical_in_lightness_about_its_neutral_middle") {
  const auto shades = colours(ColourMap::diverging, 65);
  double least = 1e9, most = 0;
  for (std::size_t i = 1; i < shades.size(); ++i) {
    const double step = colour_distance(shades[i - 1], shades[i]);
    least = std::min(least, step);
    most = std::max(most, step);
  }
  CHECK(most / least < 1.2);
  const LabColour middle = to_lab(shades[32]);
  CHECK(std::hypot(middle.a, middle.b) < 0.5);
  for (std::size_t i = 0; i < 32; ++i) {
    CHECK(to_lab(shades[i]).lightness < to_lab(shades[i + 1]).lightness);
    CHECK(std::abs(to_lab(shades[i]).lightness - to_lab(shades[64 - i]).lightness) < 5);
  }
}

TEST_CASE("positions_beyond_the_ends_give_the_end_colours") {
  CHECK(colour_at(ColourMap::sequential, -3) == colour_at(ColourMap::sequential, 0));
  CHECK(colour_at(ColourMap::sequential, 7) == colour_at(ColourMap::sequential, 1));
}

TEST_CASE("line_and_area_colours_are_far_apart_and_stand_out") {
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(to_lab(line_colour(i)).lightness < 75);  // on white
    for (std::size_t j = 0; j < i; ++j) CHECK(colour_distance(line_colour(i), line_colour(j)) > 20);
  }
  for (std::size_t i = 0; i < 12; ++i) {
    CHECK(to_lab(area_colour(i)).lightness > 70);  // under dark lines
    for (std::size_t j = 0; j < i; ++j) CHECK(colour_distance(area_colour(i), area_colour(j)) > 8);
  }
  CHECK(line_colour(8) == line_colour(0));
}
