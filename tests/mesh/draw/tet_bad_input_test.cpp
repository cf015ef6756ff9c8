// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <fstream>
#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/draw/tet_picture.hpp"
#include "tests/mesh/draw/kuhn_meshes.hpp"
#include "tests/mesh/draw/pictures.hpp"

using namespace leonhard;
using namespace leonhard::draw;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const TetMesh& cube() {
  static const TetMesh mesh = test::unit_cube(2);  // 48 tetrahedra, 27 vertices
  return mesh;
}

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
    CAPTURE(error.what());
    for (const std::string& word : words) CHECK(std::string(error.what()).find(word) != std::string::npos);
  }
  CHECK(test::bytes_of(folder / name) == "older");
}

void refused_with(const std::vector<std::string>& words, const TetPictureOptions& options) {
  refused(words, [&](const auto& path) { draw_tet_mesh(path, cube(), TetFill::plain, options); });
}

}  // namespace

TEST_CASE("pictures_of_tetrahedra_refuse_formats_sizes_and_views") {
  refused(
      {"'.jpg'"}, [](const auto& path) { draw_tet_mesh(path, cube()); }, "picture.jpg");
  refused_with({"63 x 1000"}, {.size = {.width = 63}});
  refused_with({"view", "91", "-90 to 90"}, {.view = {.elevation_deg = 91}});
  refused_with({"view", "nan"}, {.view = {.azimuth_deg = not_a_number}});
  refused_with({"view", "361"}, {.view = {.azimuth_deg = 361}});
  refused_with({"view", "61", "0 to 60"}, {.view = {.field_of_view_deg = 61}});
  refused_with({"view", "-1"}, {.view = {.field_of_view_deg = -1}});
}

TEST_CASE("pictures_of_tetrahedra_refuse_cuts_that_are_none_or_leave_nothing") {
  refused_with({"cut", "(0, 0, 0) is no plane"}, {.cut_plane = CutPlane{{0, 0, 0}, {0, 0, 0}}});
  refused_with({"cut", "nan"}, {.cut_plane = CutPlane{{0, not_a_number, 0}, {1, 0, 0}}});
  refused_with({"cut", "inf"}, {.cut_plane = CutPlane{{0, 0, 0}, {1, infinity, 0}}});
  for (const CutStyle cut : {CutStyle::crinkled, CutStyle::planar}) {
    refused_with({"cut", "leaves nothing", "move the plane"},
                 {.cut = cut, .cut_plane = CutPlane{{-1, 0, 0}, {1, 0, 0}}});
  }
}

TEST_CASE("pictures_refuse_tetrahedral_meshes_that_do_not_hold_together") {
  const auto draw = [](const TetMesh& mesh) {
    return [&mesh](const auto& path) { draw_tet_mesh(path, mesh); };
  };
  refused({"no tetrahedron"}, draw(TetMesh{}));
  TetMesh broken = cube();
  broken.corners[TetId::from(3)][1] = VertexId::from(99);
  refused({"tetrahedron 3", "vertex 99"}, draw(broken));
  broken = cube();
  broken.neighbours.clear();
  refused({"0 quadruples", "48 tetrahedra", "build_neighbours"}, draw(broken));
  broken = cube();
  broken.neighbours[TetId::from(5)][2] = TetId::from(48);
  refused({"tetrahedron 5", "neighbour 48"}, draw(broken));
  broken = cube();
  broken.points[VertexId::from(2)].z = not_a_number;
  refused({"vertex 2", "nan"}, draw(broken));
  broken = cube();
  broken.boundary[0].corners[2] = VertexId::from(27);
  refused({"boundary face", "vertex 27"}, draw(broken));
}

TEST_CASE("fields_and_partitions_that_do_not_fit_tetrahedra_are_refused") {
  const auto field = [](std::vector<double> values, TetFieldScale scale = {}) {
    return [=](const auto& path) { draw_tet_field(path, cube(), values, scale); };
  };
  refused({"26 values for 27 vertices"}, field(std::vector<double>(26, 1.0)));
  std::vector<double> values(27, 1.0);
  refused({"bands", "0"}, field(values, {.bands = 0}));
  refused({"value range"}, field(values, {.range = Range{1, 1}}));
  values[4] = infinity;
  refused({"vertex 4", "inf"}, field(values));
  const auto parts = [](std::size_t entries, std::uint32_t value, std::uint32_t count) {
    return [=](const auto& path) {
      draw_tet_partition(path, cube(), std::vector<std::uint32_t>(entries, value), count);
    };
  };
  refused({"27 entries for 48 tetrahedra"}, parts(27, 0, 1));
  refused({"entry 0 is part 4 of 4"}, parts(48, 4, 4));
  refused({"0 parts"}, parts(48, 0, 0));
}
