// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>

#include "leonhard/mesh/draw/mesh_picture.hpp"
#include "leonhard/mesh/draw/plane/scene.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

PlotFrame frame_of(const TriangleMesh& mesh, const PartitionOptions& options) {
  const test::Folder folder;
  Canvas canvas(folder / "x.png", options.size);
  return fit_map(canvas, {0, 0, canvas.width(), canvas.height()}, region_of(mesh, options.view),
                 {options.title, options.x_label, options.y_label});
}

}  // namespace

TEST_CASE("parts_of_triangles_that_touch_differ_in_colour_and_a_dark_line_parts_them") {
  const test::Folder folder;
  constexpr std::size_t n = 8;
  const TriangleMesh mesh = test::unit_square(n);
  std::vector<std::uint32_t> part_of;  // a chequerboard of 16 parts, each 2 by 2 squares
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::size_t i = t / 2 % n, j = t / 2 / n;
    part_of.push_back(static_cast<std::uint32_t>(j / 2 * 4 + i / 2));
  }
  PartitionOptions options;
  options.show_mesh = false;
  draw_partition(folder / "parts.png", mesh, part_of, 16, options);
  const test::Pixels picture(folder / "parts.png");
  const PlotFrame frame = frame_of(mesh, options);
  const auto colour = [&](int i, int j) { return picture.at(frame.page({(i + 0.5) / 4, (j + 0.4) / 4})); };
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (i > 0) CHECK(colour(i, j) != colour(i - 1, j));
      if (j > 0) CHECK(colour(i, j) != colour(i, j - 1));
    }
  }
  CHECK(test::difference(picture.at(frame.page({0.5, 0.1})), packed(ink)) < 60);
}

TEST_CASE("a_vertex_part_covers_the_median_dual_cell") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(1);
  // Vertex 0, at the origin, alone: its cell reaches to the middles of its edges.
  std::vector<std::uint32_t> part_of(mesh.vertex_count(), 1);
  for (const VertexId v : mesh.points.ids()) {
    if (mesh.points[v] == Point2{0, 0}) part_of[v.index()] = 0;
  }
  PartitionOptions options;
  options.show_mesh = false;
  draw_partition(folder / "parts.png", mesh, part_of, 2, options);
  const test::Pixels picture(folder / "parts.png");
  const PlotFrame frame = frame_of(mesh, options);
  const std::uint32_t own = picture.at(frame.page({0.1, 0.1})), other = picture.at(frame.page({0.9, 0.85}));
  CHECK(own != other);
  CHECK(picture.at(frame.page({0.46, 0.02})) == own);
  CHECK(picture.at(frame.page({0.02, 0.46})) == own);
  CHECK(picture.at(frame.page({0.54, 0.02})) == other);
  CHECK(picture.at(frame.page({0.02, 0.54})) == other);
}

TEST_CASE("many_parts_that_all_touch_get_as_many_colours") {
  const test::Folder folder;
  // A fan of 24 triangles around a hub, part by part: consecutive ones touch.
  std::vector<Point2> points{{0, 0}};
  std::vector<shelf::Corners> triangles;
  constexpr std::size_t blades = 24;
  for (std::size_t i = 0; i < blades; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / blades;
    points.push_back({std::cos(angle), std::sin(angle)});
    triangles.push_back({0, i + 1, (i + 1) % blades + 1});
  }
  const TriangleMesh mesh = shelf::build(points, triangles);
  // By vertices every rim part touches the hub and two others.
  std::vector<std::uint32_t> part_of;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) part_of.push_back(v);
  PartitionOptions options;
  options.show_mesh = false;
  draw_partition(folder / "fan.png", mesh, part_of, 25, options);
  const test::Pixels picture(folder / "fan.png");
  const PlotFrame frame = frame_of(mesh, options);
  const std::uint32_t hub = picture.at(frame.page({0.05, 0.01}));
  std::uint32_t last = picture.at(frame.page({0.9 * points.back().x, 0.9 * points.back().y}));
  for (std::size_t i = 1; i <= blades; ++i) {
    const std::uint32_t colour = picture.at(frame.page({0.9 * points[i].x, 0.9 * points[i].y}));
    CHECK(colour != hub);
    CHECK(colour != last);
    last = colour;
  }
}
