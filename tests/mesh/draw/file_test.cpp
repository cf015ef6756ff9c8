// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <filesystem>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

// Every kind of picture, under a name.
void draw_all(const std::function<std::filesystem::path(const std::string&)>& path) {
  const TriangleMesh mesh = test::square_with_hole();
  const auto values = test::values_on(mesh, [](Point2 p) { return p.x * p.y; });
  const std::vector<std::uint32_t> part_of(mesh.triangle_count(), 0), offsets{0, 1, 2}, links{1, 0};
  const std::vector<Curve> curves{{.name = "a", .x = {0, 1}, .y = {1, 3}},
                                  {.name = "b", .x = {0, 1}, .y = {2, 1}}};
  const std::vector<double> edges{0, 1, 2}, counts{3, 5};
  const MatrixPattern pattern{.offsets = offsets, .links = links, .order = {}, .title = "title"};
  draw_mesh(path("mesh"), mesh, {.title = "Mesh", .fill = MeshFill::quality, .show_vertices = true});
  draw_field(path("field"), mesh, values, {.title = "Field", .value_label = "u", .show_mesh = true});
  draw_partition(path("partition"), mesh, part_of, 1, {.title = "Partition"});
  draw_curves(path("curves"), curves, {.title = "Curves", .x_label = "x", .y_label = "y"});
  draw_histogram(path("histogram"), edges, counts, {.title = "Histogram"});
  draw_pattern(path("pattern"), std::span(&pattern, 1), "Pattern");
}

const std::vector<std::string> all{"mesh", "field", "partition", "curves", "histogram", "pattern"};

}  // namespace

TEST_CASE("png_files_have_the_size_asked_for_and_are_not_blank") {
  const test::Folder folder;
  draw_all([&](const std::string& name) { return folder / (name + ".png"); });
  for (const std::string& name : all) {
    CAPTURE(name);
    CHECK(test::bytes_of(folder / (name + ".png")).starts_with("\x89PNG\r\n"));
    const test::Pixels picture(folder / (name + ".png"));
    CHECK(picture.width == 1600);
    CHECK(picture.height == 1000);
    CHECK(picture.at(0, 0) == 0xFFFFFFFFU);
    CHECK(picture.count([](std::uint32_t word) { return word != 0xFFFFFFFFU; }) > 5000);
  }
  draw_mesh(folder / "small.PNG", test::unit_square(2), {.size = {.width = 321, .height = 123}});
  const test::Pixels small(folder / "small.PNG");
  CHECK(small.width == 321);
  CHECK(small.height == 123);
}

TEST_CASE("svg_and_pdf_files_are_whole") {
  const test::Folder folder;
  draw_all([&](const std::string& name) { return folder / (name + ".svg"); });
  draw_all([&](const std::string& name) { return folder / (name + ".pdf"); });
  for (const std::string& name : all) {
    CAPTURE(name);
    const std::string svg = test::bytes_of(folder / (name + ".svg")),
                      pdf = test::bytes_of(folder / (name + ".pdf"));
    CHECK(svg.starts_with("<?xml"));
    CHECK(svg.find("width=\"1600px\" height=\"1000px\"") != std::string::npos);
    CHECK(svg.ends_with("</svg>\n"));
    CHECK(pdf.starts_with("%PDF-1."));
    CHECK(pdf.ends_with("%%EOF\n"));
  }
}

TEST_CASE("the_same_picture_twice_is_the_same_file") {
  const test::Folder folder;
  for (const std::string extension : {".png", ".svg", ".pdf"}) {
    draw_all([&](const std::string& name) { return folder / (name + "-1" + extension); });
    draw_all([&](const std::string& name) { return folder / (name + "-2" + extension); });
    for (const std::string& name : all) {
      CAPTURE(name + extension);
      const std::string one = test::bytes_of(folder / (name + "-1" + extension));
      CHECK_FALSE(one.empty());
      const bool same = one == test::bytes_of(folder / (name + "-2" + extension));
      CHECK(same);
      CHECK(one.find("CreationDate") == std::string::npos);
    }
  }
}

TEST_CASE("large_meshes_are_embedded_as_images_and_files_stay_small") {
  const test::Folder folder;
  const TriangleMesh small = test::unit_square(40),
                     large = test::unit_square(180);  // 3,200 and 64,800 triangles
  const auto field = [](Point2 p) { return p.x * p.x + p.y; };
  const FieldOptions options{.show_mesh = true};
  draw_field(folder / "small.svg", small, test::values_on(small, field), options);
  draw_field(folder / "large.svg", large, test::values_on(large, field), options);
  CHECK(test::bytes_of(folder / "small.svg").find("<image") == std::string::npos);
  CHECK(test::bytes_of(folder / "large.svg").find("<image") != std::string::npos);
  CHECK(test::bytes_of(folder / "large.svg").size() < 4'000'000);
}

TEST_CASE("names_that_are_no_text_do_not_spoil_the_picture") {
  const test::Folder folder;
  TriangleMesh mesh = test::unit_square(2);
  mesh.marker_names[1] = "a\xff\xfe\x01 b";
  draw_mesh(folder / "mesh.png", mesh, {.title = "\xC3\x28 \xE2\x82 \xF0\x9F\x98 \xED\xA0\x80\n"});
  CHECK(test::Pixels(folder / "mesh.png").width == 1600);
}

TEST_CASE("failures_to_write_name_the_path_and_leave_nothing") {
  const test::Folder folder;
  const TriangleMesh mesh = test::unit_square(2);
  const auto missing = folder / "no/such/folder/mesh.png";
  try {
    draw_mesh(missing, mesh);
    FAIL("written into a folder that is not there");
  } catch (const OutputError& error) {
    CHECK(std::string(error.what()).find(missing.string()) != std::string::npos);
  }
  for (const std::string extension : {".png", ".svg", ".pdf"}) {
    const auto full = folder / ("full" + extension);
    std::filesystem::create_symlink("/dev/full", full);
    CHECK_THROWS_AS(draw_mesh(full, mesh), OutputError);
    std::filesystem::remove(full);
  }
  CHECK(std::filesystem::is_empty(folder.path()));
}
