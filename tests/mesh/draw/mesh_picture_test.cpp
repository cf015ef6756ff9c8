// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/mesh_picture.hpp"

#include <doctest/doctest.h>

#include "leonhard/mesh/draw/plane/scene.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

constexpr std::uint32_t body_grey = 0xFFE6E6E6U, blank = 0xFFFFFFFFU;

PlotFrame frame_of(const TriangleMesh& mesh, const MeshOptions& options) {
  const test::Folder folder;
  Canvas canvas(folder / "x.png", options.size);
  return fit_map(canvas, {0, 0, canvas.width(), canvas.height()}, region_of(mesh, options.view),
                 {options.title, options.x_label, options.y_label});
}

}  // namespace

TEST_CASE("a_mesh_shows_white_triangles_dark_edges_coloured_boundary_and_grey_body") {
  const test::Folder folder;
  const TriangleMesh mesh = test::square_with_hole();
  const MeshOptions options{.title = "Square", .legend = LegendPlace::none};
  draw_mesh(folder / "mesh.png", mesh, options);
  const test::Pixels picture(folder / "mesh.png");
  const PlotFrame frame = frame_of(mesh, options);
  CHECK(picture.at(frame.page({0.5, 0.5})) == body_grey);
  CHECK(picture.at(frame.page({0.05, 0.11})) == blank);
  CHECK(picture.at(frame.page({-0.1, 0.5})) == blank);
  CHECK(test::difference(picture.at(frame.page({0.08, 1.0 / 6})), blank) > 60);  // an edge
  CHECK(test::difference(picture.at(frame.page({1.0 / 3, 0.45})), packed(line_colour(0))) <
        60);  // the hole's side
}

TEST_CASE("no_edge_is_drawn_within_a_cell_of_several_triangles") {
  const test::Folder folder;
  const TriangleMesh mesh = test::square_with_hole();
  // The first triangle and a neighbour of it are one cell.
  std::vector<std::size_t> cell_of(mesh.triangle_count());
  for (std::size_t t = 0; t < cell_of.size(); ++t) cell_of[t] = t;
  const TriangleId first = TriangleId::from(0);
  std::size_t side = 0;
  while (!mesh.neighbours[first][side]) ++side;
  cell_of[(*mesh.neighbours[first][side]).index()] = 0;
  const Point2 a = mesh.points[mesh.corners[first][(side + 1) % 3]],
               b = mesh.points[mesh.corners[first][(side + 2) % 3]];
  for (const bool whole : {false, true}) {
    MeshOptions options{.title = "Square", .legend = LegendPlace::none};
    if (whole) options.cell_of = cell_of;
    draw_mesh(folder / "mesh.png", mesh, options);
    const test::Pixels picture(folder / "mesh.png");
    const auto shade =
        test::difference(picture.at(frame_of(mesh, options).page({(a.x + b.x) / 2, (a.y + b.y) / 2})), blank);
    CHECK((whole ? shade < 10 : shade > 60));
  }
  MeshOptions wrong;
  wrong.cell_of = std::span(cell_of).first(1);
  CHECK_THROWS_AS(draw_mesh(folder / "mesh.png", mesh, wrong), InputError);
}

TEST_CASE("a_view_is_shown_where_the_axes_say") {
  const test::Folder folder;
  const TriangleMesh mesh = test::square_with_hole();
  const MeshOptions options{.view = {Box{{0.3, 0.3}, {0.5, 0.4}}}, .legend = LegendPlace::none};
  draw_mesh(folder / "mesh.png", mesh, options);
  const test::Pixels picture(folder / "mesh.png");
  const PlotFrame frame = frame_of(mesh, options);
  // The hole's corner is at (1/3, 1/3).
  for (const double d : {0.01, 0.03}) {
    CHECK(picture.at(frame.page({1.0 / 3 + d, 1.0 / 3 + d})) == body_grey);
    CHECK(picture.at(frame.page({1.0 / 3 - d, 1.0 / 3 + d / 3})) != body_grey);
    CHECK(picture.at(frame.page({1.0 / 3 + d / 3, 1.0 / 3 - d})) != body_grey);
  }
}

TEST_CASE("a_close_up_a_millionth_of_the_mesh_is_still_right") {
  const test::Folder folder;
  const TriangleMesh mesh = test::square_with_hole();
  const double x = 1.0 / 3, y = 0.41;  // on the left side of the hole, the body to the right
  const MeshOptions options{.view = {Box{{x - 1e-7, y - 1e-7}, {x + 1e-7, y + 1e-7}}},
                            .legend = LegendPlace::none};
  for (const char* name : {"mesh.png", "mesh.svg", "mesh.pdf"}) draw_mesh(folder / name, mesh, options);
  const test::Pixels picture(folder / "mesh.png");
  const PlotFrame frame = frame_of(mesh, options);
  CHECK(picture.at(frame.page({x + 5e-8, y + 5e-8})) == body_grey);
  CHECK(picture.at(frame.page({x - 5e-8, y + 5e-8})) == blank);
}

TEST_CASE("quality_colours_triangles_by_their_smallest_angle") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(4);  // all angles 45, 45, 90
  draw_mesh(folder / "mesh.png", mesh, {.fill = MeshFill::quality, .legend = LegendPlace::none});
  const test::Pixels picture(folder / "mesh.png");
  // Twelve bands of 5 degrees; 45 begins the tenth.
  const std::uint32_t wanted = packed(colour_at(ColourMap::sequential, 9.5 / 12));
  CHECK(picture.count(wanted) > 300000);
}

TEST_CASE("regions_have_their_own_colours") {
  const test::Folder folder;
  TriangleMesh mesh = test::unit_square(2);
  for (const TriangleId t : mesh.corners.ids()) mesh.regions[t] = t.index() < 4 ? 1 : 2.5;
  draw_mesh(folder / "mesh.png", mesh, {.fill = MeshFill::region});
  const test::Pixels picture(folder / "mesh.png");
  CHECK(picture.count(packed(area_colour(0))) > 100000);
  CHECK(picture.count(packed(area_colour(1))) > 100000);
}

TEST_CASE("only_boundaries_in_view_are_in_the_legend") {
  const test::Folder folder;
  TriangleMesh mesh = test::square_with_hole();
  for (MarkedEdge& edge : mesh.boundary) {
    const Point2 p = mesh.points[edge.from];
    if (p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1) edge.marker = 2;
  }
  const View hole{Box{{0.25, 0.25}, {0.75, 0.75}}};
  draw_mesh(folder / "hole.png", mesh, {.view = hole});
  draw_mesh(folder / "whole.png", mesh, {});
  const std::uint32_t second = packed(line_colour(1));
  CHECK(test::Pixels(folder / "hole.png").count(second) == 0);
  CHECK(test::Pixels(folder / "whole.png").count(second) > 100);
}

TEST_CASE("vertices_are_marked_on_request") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(3);
  const MeshOptions options{.show_vertices = true, .legend = LegendPlace::none};
  draw_mesh(folder / "mesh.png", mesh, options);
  const Point2 inner = frame_of(mesh, options).page({1.0 / 3, 1.0 / 3});
  CHECK(test::difference(test::Pixels(folder / "mesh.png").at(inner), packed(ink)) < 40);
}
