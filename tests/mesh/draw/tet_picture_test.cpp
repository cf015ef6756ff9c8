// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/tet_picture.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "leonhard/mesh/draw/canvas/levels.hpp"
#include "leonhard/mesh/draw/space/tet_scene.hpp"
#include "tests/mesh/draw/kuhn_meshes.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

constexpr std::uint32_t blank = 0xFFFFFFFFU;
constexpr View3 from_the_front{.azimuth_deg = -90, .elevation_deg = 0};  // x to the right, z up, y away

// Nothing but the mesh, and no edges that hide colours.
TetPictureOptions bare(const View3& view, CutStyle cut = CutStyle::none) {
  return {.size = {.width = 400, .height = 250},
          .view = view,
          .cut = cut,
          .show_edges = false,
          .show_axes = false,
          .show_caption = false,
          .legend = LegendPlace::none};
}

std::uint32_t lit_word(Colour colour, const Vec3& normal_to_camera, FacetKind kind = FacetKind::boundary) {
  Facet facet;
  facet.normal = normal_to_camera;
  facet.kind = kind;
  return packed(lit(colour, brightness(facet)));
}

// Two cubes in a row: the nearer half as wide, so that the other shows around it. Markers 1 and 2.
TetMesh cube_before_another(bool near_first) {
  const auto size = [](double y) { return y < 2 ? 0.5 : 1.0; };
  TetMesh mesh = test::kuhn_mesh(
      {1, 4, 1}, [](Point3 p) { return p.y < 1 || p.y > 3; },
      [=](Point3 p) {
        return Point3{size(p.y) * (p.x - 0.5), near_first ? p.y : 4 - p.y, size(p.y) * (p.z - 0.5)};
      });
  for (MarkedFace& face : mesh.boundary) {
    face.marker = std::abs(mesh.points[face.corners[0]].x) < 0.3 ? 1 : 2;
  }
  return mesh;
}

// The mesh turned by half a turn about z, which keeps tetrahedra positive, y being counted backwards.
TetMesh turned(TetMesh mesh) {
  for (Point3& p : mesh.points) p = {-p.x, 4 - p.y, p.z};
  return mesh;
}

}  // namespace

TEST_CASE("what_is_in_front_hides_what_is_behind_in_any_order_of_tetrahedra") {
  const test::Folder folder;
  const TetMesh mesh = cube_before_another(true);
  const std::uint32_t near_colour = lit_word(area_colour(0), {0, 0, 1}),
                      far_colour = lit_word(area_colour(1), {0, 0, 1});
  draw_tet_mesh(folder / "a.png", mesh, TetFill::marker, bare(from_the_front));
  const test::Pixels a(folder / "a.png");
  CHECK(a.at(200, 125) == near_colour);
  CHECK(a.at(200, 25) == far_colour);
  CHECK(a.at(125, 125) == far_colour);
  CHECK(a.at(25, 125) == blank);
  // Half as wide and high: a quarter of the area.
  CHECK(static_cast<double>(a.count(near_colour)) ==
        doctest::Approx(static_cast<double>(a.count(far_colour)) / 3).epsilon(0.02));
  // From behind the larger one hides the other.
  draw_tet_mesh(folder / "b.png", turned(mesh), TetFill::marker, bare(from_the_front));
  const test::Pixels b(folder / "b.png");
  CHECK(b.count(near_colour) == 0);
  CHECK(b.at(200, 125) == far_colour);
}

TEST_CASE("a_cavity_shows_in_the_cut_only") {
  const test::Folder folder;
  const TetMesh mesh = test::ball(8, 0.5);
  const auto pixels_of_cavity = [&](CutStyle cut) {
    draw_tet_mesh(folder / "x.png", mesh, TetFill::marker, bare({}, cut));
    // The second marker's colour under any light: its parts keep their proportions, which the first's do not have.
    const Colour c = area_colour(1);
    return test::Pixels(folder / "x.png").count([&](std::uint32_t word) {
      const double red = word >> 16 & 0xFF, green = word >> 8 & 0xFF, blue = word & 0xFF;
      return word != blank && std::abs(green / red - c.green / c.red) < 0.02 &&
             std::abs(blue / red - c.blue / c.red) < 0.02;
    });
  };
  CHECK(pixels_of_cavity(CutStyle::none) == 0);
  CHECK(pixels_of_cavity(CutStyle::crinkled) > 3'000);
  CHECK(pixels_of_cavity(CutStyle::planar) > 3'000);
}

TEST_CASE("the_inside_has_another_colour_than_the_boundary") {
  const test::Folder folder;
  const TetMesh mesh = test::unit_cube(4);
  draw_tet_mesh(folder / "whole.png", mesh, TetFill::plain, bare(from_the_front));
  draw_tet_mesh(folder / "cut.png", mesh, TetFill::plain, bare(from_the_front, CutStyle::crinkled));
  draw_tet_mesh(folder / "section.png", mesh, TetFill::plain, bare(from_the_front, CutStyle::planar));
  const std::uint32_t outside = test::Pixels(folder / "whole.png").at(200, 125);
  const std::uint32_t inside = test::Pixels(folder / "cut.png").at(200, 125);
  CHECK(test::difference(outside, inside) > 60);
  CHECK(test::difference(test::Pixels(folder / "section.png").at(200, 125), outside) > 60);
}

TEST_CASE("edges_are_drawn_where_they_are_and_can_be_left_out") {
  const test::Folder folder;
  TetPictureOptions options = bare(from_the_front);
  draw_tet_mesh(folder / "without.png", test::unit_cube(1), TetFill::plain, options);
  options.show_edges = true;
  draw_tet_mesh(folder / "with.png", test::unit_cube(1), TetFill::plain, options);
  const test::Pixels with(folder / "with.png"), without(folder / "without.png");
  const std::uint32_t face = without.at(200, 125);
  const auto has_line = [&](const test::Pixels& picture, int x, int y) {
    int most = 0;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) most = std::max(most, test::difference(picture.at(x + i, y + j), face));
    }
    return most > 50;
  };
  // The diagonal of the face goes from the lower left to the upper right; the other way there is none.
  CHECK(has_line(with, 200, 125));
  CHECK(has_line(with, 175, 150));
  CHECK_FALSE(has_line(with, 175, 100));
  for (const int x : {175, 200, 225}) CHECK_FALSE(has_line(without, x, 325 - x));
}

TEST_CASE("tetrahedra_are_coloured_by_their_smallest_angle_between_faces") {
  const test::Folder folder;
  // Kuhn's tetrahedra have angles of 45, 60 and 90 degrees. Fifteen bands of 5 degrees: 47.5 is in the tenth, a little
  // off 45 on account of rounding.
  TetMesh mesh = test::unit_cube(4);
  for (Point3& p : mesh.points) p.z *= 1.01;
  draw_tet_mesh(folder / "x.png", mesh, TetFill::quality, bare(from_the_front, CutStyle::planar));
  const test::Pixels picture(folder / "x.png");
  const std::uint32_t ninth = packed(colour_at(ColourMap::sequential, 8.5 / 15)),
                      tenth = packed(colour_at(ColourMap::sequential, 9.5 / 15));
  CHECK(picture.count(ninth) + picture.count(tenth) > 18'000);
  CHECK(picture.count(packed(colour_at(ColourMap::sequential, 12.5 / 15))) < 1'000);  // of the bar
}

TEST_CASE("regions_and_parts_have_their_own_colours") {
  const test::Folder folder;
  TetMesh mesh = test::unit_cube(2);
  std::vector<std::uint32_t> part_of;
  for (const TetId t : mesh.corners.ids()) {
    double sum = 0;
    for (const VertexId v : mesh.corners[t]) sum += mesh.points[v].x;
    const bool right = sum > 2;
    mesh.regions[t] = right ? 7.5 : 1;
    part_of.push_back(right ? 1 : 0);
  }
  draw_tet_mesh(folder / "regions.png", mesh, TetFill::region, bare(from_the_front));
  draw_tet_partition(folder / "parts.png", mesh, part_of, 2, bare(from_the_front));
  for (const char* name : {"regions.png", "parts.png"}) {
    const test::Pixels picture(folder / name);
    CHECK(picture.at(150, 125) == lit_word(area_colour(0), {0, 0, 1}));
    CHECK(picture.at(250, 125) == lit_word(area_colour(1), {0, 0, 1}));
  }
}

TEST_CASE("a_field_has_its_bands_where_its_values_are") {
  const test::Folder folder;
  const TetMesh mesh = test::unit_cube(3);
  std::vector<double> values;
  for (const Point3& p : mesh.points) values.push_back(p.z);
  draw_tet_field(folder / "x.png", mesh, values, {.range = Range{0, 1}, .bands = 10},
                 bare(from_the_front, CutStyle::planar));
  const test::Pixels picture(folder / "x.png");
  // The square fills the height between the margins: find it by its white surroundings.
  int top = 0, bottom = picture.height - 1;
  while (picture.at(175, top) == blank) ++top;
  while (picture.at(175, bottom) == blank) --bottom;
  for (int band = 0; band < 10; ++band) {
    const double z = (band + 0.5) / 10;
    CAPTURE(z);
    CHECK(picture.at(175, static_cast<int>(bottom + z * (top - bottom))) ==
          packed(colour_at(ColourMap::sequential, z)));
  }
}

TEST_CASE("a_field_in_perspective_is_linear_in_space_not_on_the_page") {
  const test::Folder folder;
  const TetMesh mesh = test::unit_cube(1);
  std::vector<double> values;
  for (const Point3& p : mesh.points) values.push_back(p.y);
  // From above and in front: the top face recedes.
  const View3 view{.azimuth_deg = -90, .elevation_deg = 30, .field_of_view_deg = 60};
  draw_tet_field(folder / "x.png", mesh, values, {.range = Range{0, 1}, .bands = 10}, bare(view));
  const test::Pixels picture(folder / "x.png");
  const Camera camera(box_of(mesh), view);
  // Down the middle of the page the top face begins where the white ends, with y = 1, and ends with y = 0.
  const auto height = [&](double y) { return camera.see(camera.turn(Point3{0.5, y, 1})).y; };
  const int middle =
      picture.box_of(lit_word(colour_at(ColourMap::sequential, 0.05), camera.turn(Vec3{0, 0, 1})))[0] +
      25;  // somewhere left of the middle of the front edge
  int top = 0, end = 0;
  while (picture.at(middle + 50, top) == blank) ++top;
  // The front face (y = 0) is of one colour, the lowest band in another light.
  const std::uint32_t front = lit_word(colour_at(ColourMap::sequential, 0.05), camera.turn(Vec3{0, -1, 0}));
  end = top;
  while (picture.at(middle + 50, end) != front) ++end;
  const Vec3 up = camera.turn(Vec3{0, 0, 1});
  for (const double y : {0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95}) {
    const double share = (height(1) - height(y)) / (height(1) - height(0));
    CAPTURE(y);
    CHECK(picture.at(middle + 50, static_cast<int>(top + share * (end - top))) ==
          lit_word(colour_at(ColourMap::sequential, y), up));
  }
}

TEST_CASE("the_same_mesh_a_thousand_powers_of_two_larger_or_smaller_is_the_same_picture") {
  const test::Folder folder;
  for (const CutStyle cut : {CutStyle::crinkled, CutStyle::planar}) {
    draw_tet_mesh(folder / "one.png", test::ball(4), TetFill::plain, bare({}, cut));
    for (const int power : {1000, -1000}) {
      CAPTURE(power);
      TetMesh mesh = test::ball(4);
      for (Point3& p : mesh.points)
        p = {std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z, power)};
      draw_tet_mesh(folder / "other.png", mesh, TetFill::plain, bare({}, cut));
      CHECK(test::bytes_of(folder / "one.png") == test::bytes_of(folder / "other.png"));
    }
  }
}

TEST_CASE("equal_pictures_of_tetrahedra_are_equal_files") {
  const test::Folder folder;
  const TetMesh mesh = test::ball(4, 0.5);
  const TetPictureOptions options{.size = {.width = 400, .height = 250}, .title = "Ball"};
  for (const std::string name : {"x.png", "x.svg", "x.pdf"}) {
    draw_tet_mesh(folder / name, mesh, TetFill::quality, options);
    draw_tet_mesh(folder / ("again" + name), mesh, TetFill::quality, options);
    CHECK(test::bytes_of(folder / name) == test::bytes_of(folder / ("again" + name)));
  }
}

TEST_CASE("many_facets_are_an_image_in_svg_and_few_are_not") {
  const test::Folder folder;
  const View3 from_above{.azimuth_deg = 0, .elevation_deg = 90};
  const auto has_image = [&](std::size_t n) {
    const TetMesh mesh = test::kuhn_mesh({n, n, 1}, [](Point3) { return true; });
    draw_tet_mesh(folder / "x.svg", mesh, TetFill::plain, bare(from_above));
    return test::bytes_of(folder / "x.svg").find("<image") != std::string::npos;
  };
  CHECK_FALSE(has_image(20));
  CHECK(has_image(105));  // 22,050 facets on top
}

TEST_CASE("legend_title_caption_and_axes_are_there") {
  const test::Folder folder;
  TetMesh mesh = test::ball(4);
  mesh.marker_names[1] = "hull";
  const auto dark_in = [](const test::Pixels& p, int left, int top, int right, int bottom) {
    std::size_t count = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) count += p.at(x, y) != blank ? 1 : 0;
    }
    return count;
  };
  draw_tet_mesh(folder / "with.png", mesh, TetFill::marker,
                {.size = {.width = 400, .height = 250}, .title = "Ball"});
  draw_tet_mesh(folder / "bare.png", mesh, TetFill::marker, bare({}, CutStyle::crinkled));
  const test::Pixels with(folder / "with.png"), without(folder / "bare.png");
  const std::array<std::array<int, 4>, 3> places{{{0, 0, 50, 15}, {0, 212, 45, 250}, {250, 240, 400, 250}}};
  for (const auto& [left, top, right, bottom] : places) {
    CHECK(dark_in(with, left, top, right, bottom) > 20);
    CHECK(dark_in(without, left, top, right, bottom) == 0);
  }
}

TEST_CASE("of_a_wall_the_side_that_its_triangles_turn_to_the_viewer_is_drawn_in_the_colours_of_its_values") {
  const test::Folder folder;
  // A unit square across y, once turned to the front and once away; low values on the left.
  const PerId<VertexId, Point3> points(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}});
  const auto at = [](std::size_t i) { return VertexId::from(i); };
  const std::vector<std::array<VertexId, 3>> front{{at(0), at(1), at(2)}, {at(0), at(2), at(3)}},
      back{{at(0), at(2), at(1)}, {at(0), at(3), at(2)}};
  const std::vector<double> values{0, 1, 1, 0};
  const TetFieldScale scale{.label = "cp", .range = Range{0, 1}, .bands = 2};
  draw_surface_field(folder / "front.png", points, front, values, scale, bare(from_the_front));
  const test::Pixels picture(folder / "front.png");
  const auto colour_of = [&](double x) { return picture.at(static_cast<int>(x), 125); };
  FieldOptions field;
  field.value_range = scale.range, field.bands = scale.bands;
  const Bands bands = make_bands({0, 1}, field);
  REQUIRE(bands.colours.front() != bands.colours.back());
  CHECK(colour_of(110) == lit_word(bands.colours.front(), {0, 0, 1}));
  CHECK(colour_of(290) == lit_word(bands.colours.back(), {0, 0, 1}));
  CHECK_THROWS_WITH_AS(draw_surface_field(folder / "back.png", points, back, values, scale, bare(from_the_front)),
                       doctest::Contains("no triangle of it is turned to the viewer"), InputError);
  CHECK_THROWS_WITH_AS(draw_surface_field(folder / "back.png", points, {}, values, scale, bare(from_the_front)),
                       doctest::Contains("it has no triangle"), InputError);
  const std::vector<std::array<VertexId, 3>> wild{{at(0), at(1), at(7)}};
  CHECK_THROWS_WITH_AS(draw_surface_field(folder / "back.png", points, wild, values, scale, bare(from_the_front)),
                       doctest::Contains("vertex 7 is not there"), InputError);
  CHECK_FALSE(std::filesystem::exists(folder / "back.png"));
}
