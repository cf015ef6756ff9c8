// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/points_file.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/text/point_columns.hpp"

using namespace leonhard;

namespace {

/// What the InputError says that a text gives; "" if it is read.
std::string complaint(const std::string& text, const std::string& source = "p.xy") {
  try {
    (void)(source.ends_with(".node") ? io::parse_node(text, source) : io::parse_xy(text, source));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

PointSet sample() {
  PointSet set;
  set.points = {{0, 0}, {1.0 / 3, -0.0}, {1e300, 5e-324}, {0.1, std::numeric_limits<double>::max()}};
  set.markers = {1, -2, 0, 2147483647};
  set.attributes_each = 2;
  set.attributes = {0.5, 1, 2, 3, -1e-9, 0, 7, 8};
  return set;
}

}  // namespace

TEST_CASE("points_are_read_from_columns_however_they_are_separated") {
  const std::vector<Point2> expected{{1, 2}, {-0.5, 3e4}};
  for (const std::string text :
       {"1 2\n-0.5 3e4\n", "1,2\n-0.5,3e4", "1;2\r\n-0.5;3e4\r\n", "1\t2\n\n  -0.5   +3e4  \n",
        "# made by hand\n1, 2 # first\n-0.5, 3e4\n", "easting;northing\n1;2\n-0.5;3e4\n",
        "x,y\n\"1\",\"2\"\n-0.5,3e4\n", "\xEF\xBB\xBFX Y\n1 2\n-0.5 3e4\n", "1 2\n-0.5;3e4"}) {
    CAPTURE(text);
    CHECK(io::parse_xy(text, "p.csv").set.points == expected);
  }
}

TEST_CASE("columns_named_in_a_header_are_found_and_the_others_left_out_with_a_warning") {
  const PointsFile file = io::parse_xy("name,Y,X\n\"hill, low\",2,1\ndale,4,3\n", "p.csv");
  CHECK(file.set.points == std::vector<Point2>{{1, 2}, {3, 4}});
  REQUIRE(file.warnings.size() == 1);
  CHECK(holds(file.warnings[0], "p.csv:1: 1 columns"));
}

TEST_CASE("columns_of_points_of_space_are_read_as_three_and_refused_as_two") {
  CHECK(io::parse_point_columns("1 2 3\n4 5 6\n", "p.xyz", 3).coordinates ==
        std::vector<double>{1, 2, 3, 4, 5, 6});
  const std::string words = complaint("1 2\n1 2 3\n", "p.xyz");
  CHECK(holds(words, "p.xyz:2: the line has 3 columns, a point of the plane has 2"));
  CHECK(holds(words, "x and y"));
}

TEST_CASE("further_columns_of_the_plane_are_left_out_where_they_are_expected") {
  const PointsFile file = io::parse_xy("0 0 255\n2 0 128\n", "p.xy", true);
  CHECK(file.set.points == std::vector<Point2>{{0, 0}, {2, 0}});
  REQUIRE(file.warnings.size() == 1);
  CHECK(holds(file.warnings[0], "p.xy:1: 1 columns"));
}

TEST_CASE("bad_columns_are_refused_with_their_line") {
  CHECK(holds(complaint("1 2\n3\n"), "p.xy:2: the line has 1 columns"));
  CHECK(holds(complaint("1 2\n3 abc\n"), "p.xy:2: found \"abc\""));
  CHECK(holds(complaint("1,2\n3,\n"), "p.xy:2: found \"\""));
  CHECK(holds(complaint("1,5;2,5\n1,5;2,5\n"), "p.xy:1"));
  CHECK(holds(complaint("1,5;2,5\n1,5;2,5\n"), "decimals with a point"));
  // A damaged first row is no header.
  CHECK(holds(complaint("1.0O 2\n3 4\n"), "p.xy:1: found \"1.0O\""));
  CHECK(holds(complaint("l 2\n3 4\n"), "p.xy:1: found \"l\""));
  CHECK(holds(complaint("nan 1\n"), "p.xy:1: \"nan\" is not finite"));
  CHECK(holds(complaint("1 2\n1 -inf\n"), "p.xy:2: \"-inf\" is not finite"));
  CHECK(holds(complaint("1 1e999\n"), "beyond the range"));
  CHECK(holds(complaint("x y\nx y\n"), "p.xy:2: found \"x\""));
  CHECK(holds(complaint("x y z w\n1 2 3\n"), "p.xy:2: the line has 3 columns, the header 4"));
  CHECK(holds(complaint("x y\n"), "no point was found"));
  CHECK(holds(complaint("# nothing\n\n"), "no point was found"));
  CHECK(holds(complaint(std::string("1 2\n\0\1\2", 7)), "p.xy:2: found a zero byte"));
  CHECK(holds(complaint("\x89PNG\r\n\x1a\n\xff\xfe\n"), "p.xy:2"));
}

TEST_CASE("node_files_keep_attributes_and_markers_numbered_from_0_or_1") {
  const PointSet set = sample();
  CHECK(io::parse_node(io::format_node(set), "p.node").set == set);
  const PointsFile one = io::parse_node("# a\n2 2 1 1\n1 0 1 7.5 3\n2 4 5 8.5 4\n", "p.node");
  CHECK(one.set.points == std::vector<Point2>{{0, 1}, {4, 5}});
  CHECK(one.set.attributes == std::vector<double>{7.5, 8.5});
  CHECK(one.set.markers == std::vector<Marker>{3, 4});
}

TEST_CASE("bad_node_files_are_refused_with_their_line") {
  CHECK(holds(complaint("2 2 0 0\n1 0 0\n", "p.node"), "file ends where a vertex was expected"));
  CHECK(holds(complaint("1 3 0 0\n1 0 0 0\n", "p.node"), "p.node:1: the dimension is 3"));
  CHECK(holds(complaint("99999999999 2 0 0\n1 0 0\n", "p.node"), "cannot hold so many"));
  CHECK(holds(complaint("1 2 0 0\n1 0 nan\n", "p.node"), "p.node:2: \"nan\" is not finite"));
  CHECK(holds(complaint("1 2 0 0\n1 0\n", "p.node"), "p.node:2: line ends"));
  CHECK(holds(complaint("0 2 0 0\n", "p.node"), "0 vertices"));
  CHECK(holds(complaint("1 2 0 0\n1 0 0\n2 0 0\n", "p.node"), "after the last vertex"));
}

TEST_CASE("points_written_are_read_back_to_the_last_bit") {
  const auto folder = std::filesystem::temp_directory_path() / "leonhard-points-file-test";
  std::filesystem::create_directories(folder);
  const PointSet set = sample();
  for (const char* name : {"p.node", "p.xy", "p.CSV", "p.txt"}) {
    io::write_points(folder / name, set);
    const PointsFile back = io::read_points(folder / name);
    CHECK(back.set.points == set.points);
    CHECK(std::signbit(back.set.points[1].y));
  }
  CHECK_THROWS_AS(io::write_points(folder / "p.xyz", set), InputError);
  CHECK_THROWS_AS((void)io::read_points(folder / "p.pts"), InputError);
  CHECK_THROWS_AS((void)io::read_points(folder / "missing.xy"), InputError);
  std::filesystem::remove_all(folder);
}
