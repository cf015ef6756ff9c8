// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/canvas/index_raster.hpp"

#include <doctest/doctest.h>

#include <random>

#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

TEST_CASE("a_fan_of_triangles_covers_a_square_without_gap") {
  // Corners on samples and between them; slivers among the triangles.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(1, 39);
  const std::array<Point2, 4> square{{{0, 0}, {40, 0}, {40, 40}, {0, 40}}};
  for (int round = 0; round < 50; ++round) {
    const Point2 hub = round == 0 ? Point2{20, 20} : Point2{number(random), number(random)};
    IndexRaster raster({0, 0, 40, 40}, 1);
    for (std::size_t i = 0; i < 4; ++i) raster.fill({hub, square[i], square[(i + 1) % 4]}, 0);
    const Raster image = raster.resolve(std::vector{Colour{1, 0, 0}});
    for (const std::uint32_t pixel : image.pixels) CHECK(pixel == 0xFFFF0000U);
  }
}

TEST_CASE("what_no_triangle_covers_is_transparent_and_edges_are_smooth") {
  IndexRaster raster({10, 10, 20, 20}, 1);
  raster.fill({Point2{10, 10}, Point2{20.5, 10}, Point2{10, 30}}, 0);
  raster.fill({Point2{20.5, 10}, Point2{20.5, 30}, Point2{10, 30}}, 0);
  const Raster image = raster.resolve(std::vector{Colour{1, 1, 1}});
  CHECK(image.pixels[5 * 20 + 3] == 0xFFFFFFFFU);
  CHECK(image.pixels[5 * 20 + 15] == 0U);
  const std::uint32_t edge = image.pixels[5 * 20 + 10] >> 24;  // half covered; a third or two of the samples
  CHECK(edge > 70);
  CHECK(edge < 185);
}

TEST_CASE("values_choose_the_colour_by_the_levels_below_them") {
  IndexRaster raster({0, 0, 90, 30}, 1);
  const std::vector<double> levels{1.0 / 3, 2.0 / 3};
  // u = x / 90
  raster.fill({Point2{0, 0}, Point2{90, 0}, Point2{0, 30}}, {0, 1, 0}, levels);
  raster.fill({Point2{90, 0}, Point2{90, 30}, Point2{0, 30}}, {1, 1, 0}, levels);
  const std::vector<Colour> colours{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Raster image = raster.resolve(colours);
  for (int x = 0; x < 90; ++x) {
    for (int y = 0; y < 30; ++y) {
      const std::uint32_t wanted = packed(colours[static_cast<std::size_t>(x / 30)]);
      CHECK(image.pixels[static_cast<std::size_t>(y * 90 + x)] == wanted);
    }
  }
}

TEST_CASE("triangles_millions_of_pixels_large_are_cut_to_the_image") {
  IndexRaster raster({0, 0, 10, 10}, 1);
  raster.fill({Point2{-1e12, -1e12}, Point2{1e12, -1e12}, Point2{0, 1e12}}, 0);
  for (const std::uint32_t pixel : raster.resolve(std::vector{Colour{0, 1, 0}}).pixels)
    CHECK(pixel == 0xFF00FF00U);
}
