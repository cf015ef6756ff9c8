// SPDX-License-Identifier: MIT
#include "leonhard/mesh/draw/diagram.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

constexpr std::uint32_t blank = 0xFFFFFFFFU;
constexpr Colour red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};

Diagram everything() {
  Diagram diagram;
  diagram.region = Box{{0, 0}, {8, 8}};
  diagram.areas.push_back({.corners = {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, .colour = red});
  diagram.add_segment({0, 6}, {8, 6}, {.colour = green, .width = 4});
  diagram.circles.push_back({{6, 3}, 1, {.colour = blue, .width = 4}});
  diagram.add_named_dot({5, 7}, "P");
  return diagram;
}

}  // namespace

TEST_CASE("a_diagram_has_its_shapes_where_they_belong") {
  const test::Folder folder;
  draw_diagram(folder / "a.png", everything(), {800, 800});
  const test::Pixels picture(folder / "a.png");
  const auto at = [&](double x, double y) {  // without axes the region fills the page but for a rim
    const double rim = 0.5 * Canvas(folder / "b.png", {800, 800}).text_size(), unit = (800 - 2 * rim) / 8;
    return picture.at(Point2{rim + x * unit, 800 - rim - y * unit});
  };
  CHECK(at(2, 2) == packed(red));
  CHECK(at(4, 6) == packed(green));
  CHECK(at(6, 4) == packed(blue));
  CHECK(at(5, 3) == packed(blue));
  CHECK(at(6, 3) == blank);
  CHECK(at(5, 7) == packed({0.1, 0.1, 0.1}));
  CHECK(at(4, 4) == blank);
}

TEST_CASE("diagrams_are_written_in_every_format_alone_in_panels_and_with_a_scale") {
  const test::Folder folder;
  Diagram scaled = everything();
  scaled.axes = true;
  scaled.areas[0].value = 2;
  scaled.areas.push_back({.corners = {{4, 4}, {5, 4}, {5, 5}}, .value = 7});
  scaled.scale_label = "area";
  const std::vector<Diagram> panels{everything(), scaled, everything()};
  for (const char* name : {"p.png", "p.svg", "p.pdf"}) {
    draw_diagrams(folder / name, panels, 2, "Panels", {600, 400});
    const std::string first = test::bytes_of(folder / name);
    CHECK(first.size() > 1000);
    draw_diagrams(folder / name, panels, 2, "Panels", {600, 400});
    CHECK(test::bytes_of(folder / name) == first);
  }
}

TEST_CASE("circles_of_any_size_and_far_points_do_not_spoil_a_diagram") {
  const test::Folder folder;
  Diagram diagram = everything();
  diagram.circles.push_back({{4, -1e12}, 1e12, {.colour = blue}});
  diagram.add_segment({4, 4}, {1e200, -1e250});
  diagram.dots.push_back({{1e300, 0}});
  draw_diagram(folder / "a.png", diagram, {400, 400});
  CHECK(test::Pixels(folder / "a.png").count(packed(red)) > 1000);
}

TEST_CASE("bad_diagrams_are_refused_and_no_file_written") {
  const test::Folder folder;
  CHECK_THROWS_AS(draw_diagram(folder / "a.png", Diagram{}), InputError);
  CHECK_THROWS_AS(draw_diagrams(folder / "a.png", {}, 1), InputError);
  Diagram nan;
  nan.dots.push_back({{std::numeric_limits<double>::quiet_NaN(), 0}});
  CHECK_THROWS_AS(draw_diagram(folder / "a.png", nan), InputError);
  Diagram empty = everything();
  empty.region = Box{{1, 1}, {1, 2}};
  CHECK_THROWS_AS(draw_diagram(folder / "a.png", empty), InputError);
  CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
}
