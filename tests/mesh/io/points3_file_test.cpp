// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/points3_file.hpp"

#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/mesh/io/sample_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

PointSet3 sample() {
  PointSet3 set;
  set.points = {
      {0, 0, 1}, {1.0 / 3, -0.0, 0.1}, {1e300, 5e-324, -7}, {0.1, std::numeric_limits<double>::max(), 2}};
  set.markers = {1, -2, 0, 2147483647};
  set.attributes_each = 2;
  set.attributes = {0.5, 1, 2, 3, -1e-9, 0, 7, 8};
  return set;
}

}  // namespace

TEST_CASE("node_of_space_keeps_points_attributes_and_markers_to_the_last_bit") {
  CHECK(io::parse_node3(io::format_node3(sample()), "p.node").set == sample());
  const PointSet3 from_one =
      io::parse_node3("# tetgen\n2 3 1 1\n1 0 0 5 .5 7\n\n2 1 2 3 .25 8 # last\n", "p.node").set;
  CHECK(from_one.points == std::vector<Point3>{{0, 0, 5}, {1, 2, 3}});
  CHECK(from_one.attributes == std::vector<double>{0.5, 0.25});
  CHECK(from_one.markers == std::vector<Marker>{7, 8});
}

TEST_CASE("columns_behind_the_coordinates_are_left_out_if_every_line_has_them") {
  const Points3File file = io::parse_xyz("0 0 1 255 128 0\n2 0 1 255 128 9\n", "p.xyz");
  CHECK(file.set.points == std::vector<Point3>{{0, 0, 1}, {2, 0, 1}});
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("p.xyz:1: 3 columns") == 0);
  check_refused({{"fewer", "0 0 0 7\n1 1 1\n", {"p.xyz:2", "3 columns, the first line 4"}}},
                [](const std::string& text) { (void)io::parse_xyz(text, "p.xyz"); });
}

TEST_CASE("columns_of_space_are_read_however_they_are_separated_and_named") {
  const std::vector<Point3> expected{{1, 2, 3}, {-0.5, 3e4, 0}};
  for (const std::string text : {"1 2 3\n-0.5 3e4 0\n", "1;2;3\r\n-.5;3e4;0",
                                 "# c\nx,y,z\n1,2,3\n-0.5,3e4,0\n", "Z Y X w\n3 2 1 9\n0 3e4 -0.5 9\n"})
    CHECK(io::parse_xyz(text, "p.xyz").set.points == expected);
  for (const char separator : {' ', ','})
    CHECK(io::parse_xyz(io::format_xyz(sample(), separator), "p").set.points == sample().points);
}

TEST_CASE("points_of_space_come_back_from_every_file_that_can_be_written") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "leonhard_points3_file_test";
  std::filesystem::create_directories(folder);
  for (const char* name : {"p.node", "p.xyz", "p.xy", "p.csv", "p.txt"}) {
    CAPTURE(name);
    io::write_points3(folder / name, sample());
    CHECK(io::read_points3(folder / name).set.points == sample().points);
  }
  CHECK(refusal([&] { io::write_points3(folder / "p.stl", sample()); }).find("known are .node") !=
        std::string::npos);
  std::ofstream(folder / "s.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 2\n3 0 1 2\n";
  CHECK(io::read_points3(folder / "s.off").set.points.back() == Point3{0, 1, 2});
  std::filesystem::remove_all(folder);
}

TEST_CASE("bad_points_of_space_are_refused_with_their_line") {
  check_refused({{"plane", "2 2 0 0\n1 0 0\n2 1 1\n", {"p.node:1", "dimension is 2"}},
                 {"NaN", "2 3 0 0\n1 0 0 0\n2 1 nan 1\n", {"p.node:3", "nan", "y coordinate"}},
                 {"two columns", "2 3 0 0\n1 0 0 0\n2 1 1\n", {"p.node:3", "z coordinate"}},
                 {"too many", "1 3 0 0\n1 0 0 0\n2 1 1 1\n", {"p.node:3", "after the last vertex"}},
                 {"too few", "3 3 0 0\n1 0 0 0\n2 1 1 1\n", {"p.node:3", "file ends"}},
                 {"count", "300 3 0 0\n1 0 0 0\n", {"p.node:1", "300", "cannot hold"}},
                 {"order", "2 3 0 0\n1 0 0 0\n3 1 1 1\n", {"p.node:3", "vertex 3", "vertex 2"}},
                 {"none", "0 3 0 0\n", {"p.node", "0 vertices"}},
                 {"binary", std::string("2 3\n\0\0", 6), {"p.node:2", "zero byte"}}},
                [](const std::string& text) { (void)io::parse_node3(text, "p.node"); });
  check_refused({{"NaN", "0 0 0\n1 NaN 0\n", {"p.xyz:2", "NaN"}},
                 {"two columns", "0 0 0\n1 1\n", {"p.xyz:2", "2 columns", "space has 3"}},
                 {"four columns", "0 0 0\n1 1 1 1\n", {"p.xyz:2", "4 columns"}},
                 {"letters", "0 0 0\n1 l 0\n", {"p.xyz:2", "\"l\""}}},
                [](const std::string& text) { (void)io::parse_xyz(text, "p.xyz"); });
  CHECK(refusal([] { (void)io::read_points3("p.stll"); }).find("did you mean \".stl\"?") !=
        std::string::npos);
}
