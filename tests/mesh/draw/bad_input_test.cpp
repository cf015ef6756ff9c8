// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Refused with these words in the message, an older file of that name untouched.
void refused(const std::vector<std::string>& words,
             const std::function<void(const std::filesystem::path&)>& draw,
             const std::string& name = "picture.png") {
  const test::Folder folder;
  std::ofstream(folder / name) << "older";
  try {
    draw(folder / name);
    FAIL("not refused: " << words.front());
  } catch (const InputError& error) {
    for (const std::string& word : words) {
      CAPTURE(error.what());
      CHECK(std::string(error.what()).find(word) != std::string::npos);
    }
  }
  CHECK(test::bytes_of(folder / name) == "older");
}

const TriangleMesh& square() {
  static const TriangleMesh mesh = test::unit_square(2);
  return mesh;
}

std::vector<double> ones() { return std::vector<double>(square().vertex_count(), 1); }

}  // namespace

TEST_CASE("unknown_formats_are_refused") {
  const auto draw = [](const auto& path) { draw_mesh(path, square()); };
  refused({"'.jpg'", ".png, .svg or .pdf"}, draw, "picture.jpg");
  refused({"needs an extension"}, draw, "picture");
}

TEST_CASE("sizes_out_of_range_are_refused") {
  refused({"63 x 100"},
          [](const auto& path) { draw_mesh(path, square(), {.size = {.width = 63, .height = 100}}); });
  refused({"0 x 0"},
          [](const auto& path) { draw_mesh(path, square(), {.size = {.width = 0, .height = 0}}); });
  refused({"picture scale", "nan"},
          [](const auto& path) { draw_mesh(path, square(), {.size = {.scale = not_a_number}}); });
}

TEST_CASE("views_that_are_no_region_are_refused") {
  for (const Box box : {Box{{0, 0}, {0, 1}}, Box{{1, 0}, {0, 1}}, Box{{0, not_a_number}, {1, 1}},
                        Box{{0, 0}, {infinity, 1}}}) {
    refused({"view"}, [&](const auto& path) { draw_mesh(path, square(), {.view = {box}}); });
    refused({"view"}, [&](const auto& path) { draw_field(path, square(), ones(), {.view = {box}}); });
  }
}

TEST_CASE("meshes_that_do_not_hold_together_are_refused") {
  refused({"no triangle"}, [](const auto& path) { draw_mesh(path, TriangleMesh{}); });
  TriangleMesh broken = square();
  broken.corners[TriangleId::from(3)][1] = VertexId::from(99);
  refused({"triangle 3", "vertex 99"}, [&](const auto& path) { draw_mesh(path, broken); });
  broken = square();
  broken.neighbours.clear();
  refused({"neighbours"}, [&](const auto& path) { draw_mesh(path, broken); });
  broken = square();
  broken.points[VertexId::from(2)].x = not_a_number;
  refused({"vertex 2"}, [&](const auto& path) { draw_mesh(path, broken); });
}

TEST_CASE("fields_that_do_not_fit_are_refused") {
  refused({"8 values for 9 vertices"},
          [](const auto& path) { draw_field(path, square(), std::vector<double>(8, 1.0)); });
  auto values = ones();
  values[5] = not_a_number;
  refused({"vertex 5", "nan"}, [&](const auto& path) { draw_field(path, square(), values); });
  refused({"value range"}, [](const auto& path) {
    draw_field(path, square(), ones(), {.value_range = Range{2, 1}});
  });
  refused({"bands"}, [](const auto& path) { draw_field(path, square(), ones(), {.bands = 0}); });
  refused({"level 2"}, [](const auto& path) { draw_field(path, square(), ones(), {.levels = {0, 1, 1}}); });
}

TEST_CASE("partitions_that_do_not_fit_are_refused") {
  const auto draw = [](std::size_t entries, std::uint32_t value, std::uint32_t parts) {
    return [=](const auto& path) {
      draw_partition(path, square(), std::vector<std::uint32_t>(entries, value), parts);
    };
  };
  refused({"7 entries", "8 triangles", "9 vertices"}, draw(7, 0, 1));
  refused({"entry 0 is part 4 of 4"}, draw(8, 4, 4));
  refused({"0 parts"}, draw(8, 0, 0));
}

TEST_CASE("curves_that_do_not_fit_are_refused") {
  const auto draw = [](Curve curve, AxesOptions axes = {}) {
    return [=](const auto& path) { draw_curves(path, std::span(&curve, 1), axes); };
  };
  refused({"'Cp'", "2 x and 1 y"}, draw({.name = "Cp", .x = {0, 1}, .y = {0}}));
  refused({"no point"}, draw({.name = "", .x = {0, 1}, .y = {not_a_number, not_a_number}}));
  refused({"no point"}, draw({.name = "", .x = {0, 1}, .y = {0, -1}}, {.log_y = true}));
  refused({"no point"}, [](const auto& path) { draw_curves(path, {}, {}); });
  refused({"y range"}, draw({.name = "", .x = {0, 1}, .y = {0, 1}}, {.y_range = Range{1, 1}}));
  refused({"logarithmic"},
          draw({.name = "", .x = {0, 1}, .y = {1, 1}}, {.log_y = true, .y_range = Range{0, 1}}));
  refused({"panels"}, [](const auto& path) { draw_panels(path, {}, ""); });
}

TEST_CASE("histograms_that_do_not_fit_are_refused") {
  const auto draw = [](std::vector<double> edges, std::vector<double> counts) {
    return [=](const auto& path) { draw_histogram(path, edges, counts, {}); };
  };
  refused({"2 bin edges", "2 counts"}, draw({0, 1}, {1, 1}));
  refused({"bin 1", "from 2 to 1"}, draw({0, 2, 1}, {1, 1}));
  refused({"bin 0", "-1"}, draw({0, 1}, {-1}));
  refused({"0 counts"}, draw({}, {}));
}

TEST_CASE("patterns_that_do_not_hold_together_are_refused") {
  using Numbers = std::vector<std::uint32_t>;
  const auto draw = [](Numbers offsets, Numbers links, Numbers order = {}) {
    return [=](const auto& path) {
      const MatrixPattern pattern{.offsets = offsets, .links = links, .order = order, .title = "A"};
      draw_pattern(path, std::span(&pattern, 1));
    };
  };
  refused({"no rows"}, draw({0}, {}));
  refused({"1 to 2"}, draw({1, 2}, {0}));
  refused({"fall after row 1"}, draw({0, 2, 1, 2}, {0, 1}));
  refused({"row 1", "column 7 of 2"}, draw({0, 1, 2}, {0, 7}));
  refused({"3 entries for 2 rows"}, draw({0, 1, 2}, {0, 1}, {0, 1, 2}));
  refused({"entry 1 is 0", "came before"}, draw({0, 1, 2}, {0, 1}, {0, 0}));
  refused({"entry 0 is 5", "no row"}, draw({0, 1, 2}, {0, 1}, {5, 0}));
  refused({"there is none"}, [](const auto& path) { draw_pattern(path, {}); });
}
