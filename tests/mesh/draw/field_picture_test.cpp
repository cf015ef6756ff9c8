// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "leonhard/mesh/draw/mesh_picture.hpp"
#include "leonhard/mesh/draw/plane/field_layout.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

FieldLayout layout_of(const TriangleMesh& mesh, std::span<const double> values, const FieldOptions& options) {
  const test::Folder folder;
  Canvas canvas(folder / "x.png", options.size);
  return lay_out_field(canvas, mesh, values, options);
}

}  // namespace

TEST_CASE("a_pixel_has_the_colour_of_the_value_there") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(7);
  const auto field = [](Point2 p) { return 2 * p.x - p.y; };  // linear, so exact between vertices
  const auto values = test::values_on(mesh, field);
  FieldOptions options{.title = "2 x − y", .value_label = "u"};
  options.contour_lines = false;
  options.bands = 12;
  draw_field(folder / "field.png", mesh, values, options);
  const test::Pixels picture(folder / "field.png");
  const auto [frame, bar, bands] = layout_of(mesh, values, options);
  int compared = 0;
  for (double x = 0.03; x < 0.98; x += 0.0171) {
    for (double y = 0.03; y < 0.98; y += 0.0193) {
      const std::size_t band = bands.index_of(field({x, y}));
      if (bands.index_of(field({x, y}) + 0.01) != band || bands.index_of(field({x, y}) - 0.01) != band)
        continue;
      CHECK(picture.at(frame.page({x, y})) == packed(bands.colours[band]));
      ++compared;
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("contour_lines_run_dark_along_the_levels") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(5);
  const auto values = test::values_on(mesh, [](Point2 p) { return p.x; });
  const FieldOptions options{.colour_map = ColourMap::grey, .levels = {0.77}};
  draw_field(folder / "field.png", mesh, values, options);
  const test::Pixels picture(folder / "field.png");
  const auto [frame, bar, bands] = layout_of(mesh, values, options);
  const auto green = [&](int x, int y) { return static_cast<int>(picture.at(x, y) >> 8 & 0xFF); };
  const Point2 on = frame.page({0.77, 0.52});
  const int x = static_cast<int>(on.x), y = static_cast<int>(on.y);
  CHECK(std::min({green(x - 1, y), green(x, y), green(x + 1, y)}) < 80);
  CHECK(green(x - 20, y) > 100);
  CHECK(green(x + 20, y) > 150);
}

TEST_CASE("contour_lines_below_the_asked_value_are_dashed") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(5);
  const auto values = test::values_on(mesh, [](Point2 p) { return p.x; });
  const FieldOptions options{.colour_map = ColourMap::grey, .levels = {0.63, 0.83}, .dashed_below = 0.7};
  draw_field(folder / "field.png", mesh, values, options);
  const test::Pixels picture(folder / "field.png");
  const auto [frame, bar, bands] = layout_of(mesh, values, options);
  const auto dark_share = [&picture, &frame = frame](double at) {
    int dark = 0, all = 0;
    for (double y = 0.1; y < 0.9; y += 0.001, ++all) {
      const Point2 on = frame.page({at, y});
      int least = 255;
      for (int dx = -1; dx <= 1; ++dx)
        least = std::min(
            least,
            static_cast<int>(picture.at(static_cast<int>(on.x) + dx, static_cast<int>(on.y)) >> 8 & 0xFF));
      dark += least < 90;
    }
    return static_cast<double>(dark) / all;
  };
  CHECK(dark_share(0.83) == 1);
  CHECK(dark_share(0.63) > 0.4);
  CHECK(dark_share(0.63) < 0.8);
}

TEST_CASE("the_colour_bar_shows_every_band") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(3);
  const auto values = test::values_on(mesh, [](Point2 p) { return p.y; });
  FieldOptions options;
  options.bands = 8;
  draw_field(folder / "field.png", mesh, values, options);
  const test::Pixels picture(folder / "field.png");
  const auto [frame, bar, bands] = layout_of(mesh, values, options);
  const int x = static_cast<int>(bar.left + 0.3 * 23 + 10);
  for (std::size_t i = 0; i < bands.colours.size(); ++i) {
    const double y = bar.bottom() -
                     (static_cast<double>(i) + 0.5) / static_cast<double>(bands.colours.size()) * bar.height;
    CHECK(picture.at(x, static_cast<int>(y)) == packed(bands.colours[i]));
  }
}

TEST_CASE("levels_are_chosen_for_what_is_in_view") {
  const TriangleMesh mesh = test::unit_square(40);
  const auto values = test::values_on(mesh, [](Point2 p) { return std::exp(5 * p.x); });
  const FieldOptions options{.view = {Box{{0, 0.4}, {0.15, 0.5}}}};
  const Range range = layout_of(mesh, values, options).bands.range;
  CHECK(range.low >= 0.9);
  CHECK(range.high < 3);
}

TEST_CASE("a_plateau_on_a_nice_value_is_one_band_though_it_is_noisy") {
  const TriangleMesh mesh = test::unit_square(40);
  int count = 0;
  // A shock: 2 with noise of alternating sign on two thirds of the square, falling to 1.6 beyond.
  const auto values = test::values_on(
      mesh, [&](Point2 p) { return p.x < 0.65 ? 2 + (++count % 2 == 0 ? 1e-4 : -1e-4) : 1.6 + 0.1 * p.y; });
  const Bands bands = layout_of(mesh, values, {}).bands;
  CHECK(bands.index_of(2 - 1e-3) == bands.index_of(2 + 1e-3));
  // Without a plateau, nice values are levels.
  const Bands even =
      layout_of(mesh, test::values_on(mesh, [](Point2 p) { return 1.6 + 0.4 * p.x; }), {}).bands;
  CHECK(std::ranges::find(even.levels, 1.8) != even.levels.end());
}

TEST_CASE("a_constant_field_is_drawn_in_one_colour") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(3);
  const std::vector<double> values(mesh.vertex_count(), 0.8);
  draw_field(folder / "field.png", mesh, values);
  const test::Pixels picture(folder / "field.png");
  CHECK(picture.count(packed(colour_at(ColourMap::sequential, 0.5))) > 500000);
}
