// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/plot3d.hpp"

#include <cmath>
#include <fstream>
#include <numbers>

#include "leonhard/mesh/mixed_euler.hpp"
#include "leonhard/mesh/words.hpp"
#include "tests/mesh/io/folder.hpp"
#include "tests/mesh/io/sample_tet_meshes.hpp"
#include "tests/mesh/mixed_shelf.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

/// Points of a block in the file's order, i fastest.
struct Block {
  std::size_t i, j;
  std::vector<Point2> points;
};

std::string format(const std::vector<Block>& blocks, bool with_count = true) {
  std::string text = with_count ? std::to_string(blocks.size()) + "\n" : "";
  for (const Block& block : blocks) text += std::to_string(block.i) + " " + std::to_string(block.j) + "\n";
  for (const Block& block : blocks) {
    for (const Point2& p : block.points) text += mesh::words(p.x) + "\n";
    for (const Point2& p : block.points) text += mesh::words(p.y) + " ";
    text += "\n";
  }
  return text;
}

/// 3 by 2 points.
const std::string strip = "1\n3 2\n0 1 2 0 1 2\n0 0 0\n1 1 1\n";

/// A grid that begins behind a body, goes round it and ends where it began: 3 edges of wake, 6 round the body.
///
/// gap  by which the points of the cut's second side lie off those of the first
Block c_grid(double gap = 0) {
  constexpr std::size_t wake = 3, body = 6, layers = 2;
  Block block{2 * wake + body + 1, layers + 1, {}};
  for (std::size_t j = 0; j <= layers; ++j) {
    for (std::size_t i = 0; i < block.i; ++i) {
      const double out = j == 0 ? 0 : 1 + static_cast<double>(j);
      if (i <= wake) {
        block.points.push_back({1 + static_cast<double>(wake - i), -out});
      } else if (i >= wake + body) {
        block.points.push_back({1 + static_cast<double>(i - wake - body), j == 0 ? gap : out});
      } else {  // an ellipse, half circles about it
        const double turn = -2 * std::numbers::pi * static_cast<double>(i - wake) / body;
        const double angle = -0.5 * std::numbers::pi + 0.5 * turn;
        block.points.push_back(j == 0 ? Point2{0.5 + 0.5 * std::cos(turn), 0.45 * std::sin(turn)}
                                      : Point2{1 + out * std::cos(angle), out * std::sin(angle)});
      }
    }
  }
  return block;
}

/// The map of c_grid, as of the plane.
const std::string c_map =
    "# a comment\n1\n1 13 3 1\n# Type B1 F1 S1 E1 S2 E2 B2 F2 S1 E1 S2 E2 Swap\n'ONE_TO_ONE' 1 3 1 4 1 1  1 "
    "3 13 10 1 1 "
    "FALSE\n'viscous_solid' 1 3 4 10 1 1\n'outflow' 1 1 1 3 1 1\n'outflow' 1 2 1 3 1 1\n'farfield' 1 4 1 13 "
    "1 1\n";

/// The same of the grid moved along its third direction, which is the map's first one.
const std::string c_map_moved =
    "1\n1 2 13 3\none_to_one 1 1 1 2 1 4  1 1 1 2 13 10 FALSE\nSYMMETRY 1 3 1 13 1 3\nSYMMETRY 1 4 1 13 1 "
    "3\nviscous_solid 1 1 1 2 4 10\noutflow 1 5 1 3 1 2\noutflow 1 6 1 3 1 2\nfarfield 1 2 1 2 1 13\n";

MixedMeshFile<2> parse(const std::string& text) { return io::parse_plot3d(text, "m.p2dfmt"); }
MixedMeshFile<2> parse_mapped(const std::string& text, const std::string& map) {
  return io::parse_plot3d(text, "m.p2dfmt", map, "m.nmf");
}

std::size_t edges_named(const MixedMesh<2>& mesh, const std::string& name) {
  return static_cast<std::size_t>(
      std::count_if(mesh.boundary.begin(), mesh.boundary.end(), [&](const auto& edge) {
        const auto at = mesh.marker_names.find(edge.marker);
        return at != mesh.marker_names.end() && at->second == name;
      }));
}

}  // namespace

TEST_CASE("plot3d_grid_becomes_quadrilaterals_and_its_sides_are_named") {
  for (const std::string& text : {strip, strip.substr(2)}) {  // with the number of blocks and without
    const MixedMeshFile<2> file = parse(text);
    CHECK(file.warnings.empty());
    CHECK(file.mesh.points.size() == 6);
    CHECK(file.mesh.count_of(CellKind::quadrilateral) == 2);
    CHECK(std::vector<VertexId>(file.mesh.corners_of(CellId{1}).begin(),
                                file.mesh.corners_of(CellId{1}).end()) ==
          std::vector{VertexId{1}, VertexId{2}, VertexId{5}, VertexId{4}});
    CHECK(edges_named(file.mesh, "i_min") == 1);
    CHECK(edges_named(file.mesh, "i_max") == 1);
    CHECK(edges_named(file.mesh, "j_min") == 2);
    CHECK(edges_named(file.mesh, "j_max") == 2);
  }
}

TEST_CASE("plot3d_blocks_that_turn_the_other_way_are_turned_over") {
  const MixedMeshFile<2> file = parse("1\n3 2\n0 1 2 0 1 2\n1 1 1 0 0 0\n");
  CHECK(file.warnings.empty());
  CHECK(file.mesh.cell_count() == 2);
  // One of two blocks: side by side, their common side in the opposite direction.
  const Block right{2, 2, {{2, 0}, {2, 1}, {1, 0}, {1, 1}}}, left{2, 2, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
  const MixedMeshFile<2> two = parse(format({left, right}));
  CHECK(two.mesh.vertex_count() == 6);
  CHECK(two.mesh.boundary.size() == 6);
  CHECK(edges_named(two.mesh, "block_1_i_max") == 0);
  CHECK(edges_named(two.mesh, "block_2_i_min") == 1);
  CHECK(two.warnings ==
        std::vector<std::string>{"2 points on sides of blocks are equal to others and were joined"});
}

TEST_CASE("plot3d_cut_behind_a_body_is_joined_where_points_are_equal") {
  const MixedMesh<2> mesh = parse(format({c_grid()})).mesh;
  CHECK(mesh.vertex_count() == 13 * 3 - 4);
  CHECK(mesh.cell_count() == 24);
  CHECK(edges_named(mesh, "j_min") == 6);  // the body
  CHECK(edges_named(mesh, "j_max") == 12);
  CHECK(edges_named(mesh, "i_min") == 2);
  const MixedEulerAccount account = mesh::euler_account(mesh);
  CHECK(account.balances());
  CHECK(account.cavities == 1);
}

TEST_CASE("plot3d_cut_is_joined_as_the_map_says_and_patches_become_markers") {
  for (const std::string& map : {c_map, c_map_moved}) {
    for (const double gap : {0.0, 1e-9}) {
      const MixedMeshFile<2> file = parse_mapped(format({c_grid(gap)}), map);
      CHECK(file.mesh.vertex_count() == 13 * 3 - 4);
      CHECK(file.mesh.points[VertexId{0}] == Point2{4, 0});
      CHECK(edges_named(file.mesh, "viscous_solid") == 6);
      CHECK(edges_named(file.mesh, "outflow") == 4);
      CHECK(edges_named(file.mesh, "farfield") == 12);
      CHECK(file.mesh.marker_names.size() == 3);
      REQUIRE(file.warnings.size() == (gap == 0 ? 0 : 1));
      if (gap != 0)
        CHECK(file.warnings[0] ==
              "points that the map joins are not equal, but up to 1e-09 apart; the first one of each was "
              "taken");
    }
  }
  // Without the map the open cut is a boundary.
  CHECK(parse(format({c_grid(1e-3)})).mesh.vertex_count() == 13 * 3);
}

TEST_CASE("plot3d_side_drawn_together_to_a_point_has_triangles") {
  const MixedMesh<2> mesh = parse("1\n3 3\n0 0 0 1 1.5 2 2 3 4\n0 0 0 -1 0 1 -2 0 2\n").mesh;
  CHECK(mesh.vertex_count() == 7);
  CHECK(mesh.count_of(CellKind::triangle) == 2);
  CHECK(mesh.count_of(CellKind::quadrilateral) == 2);
  CHECK(mesh.boundary.size() == 6);
}

TEST_CASE("plot3d_bad_grids_are_refused") {
  check_refused(
      {{"empty", "", {"m.p2dfmt", "number of blocks"}},
       {"no number", "one\n", {"m.p2dfmt:1", "one"}},
       {"no blocks", "0\n", {"m.p2dfmt:1", "found 0"}},
       {"one point", "1\n1 4\n0 0 0 0 0 0 0 0\n", {"m.p2dfmt:2", "found 1 points"}},
       {"beyond count", "4611686018427387904 4\n0 0\n", {"m.p2dfmt:1", "found 4611686018427387904 points"}},
       {"huge", "1\n2000000 2000000\n0 0\n", {"cannot hold a block of 2000000 by 2000000"}},
       {"cut short", strip.substr(0, strip.size() - 3), {"m.p2dfmt:2", "cannot hold", "cut short"}},
       {"a coordinate short",
        replaced(strip, "\n0 1", "\n0.000000 1").substr(0, strip.size() + 4),
        {"m.p2dfmt:5", "a coordinate"}},
       {"more", strip + "7\n", {"m.p2dfmt:6", "end of the file"}},
       {"third dimension", replaced(strip, "3 2", "3 2 1"), {"m.p2dfmt:2", "sizes of the blocks"}},
       {"NaN", replaced(strip, "0 1 2", "0 nan 2"), {"m.p2dfmt:3", "nan"}},
       {"no area",
        replaced(strip, "0 1 2 0 1 2", "0 0 2 0 0 2"),
        {"cell 1, 1 of block 1 at (0, 0)", "no area"}},
       {"flat",
        replaced(replaced(strip, "0 1 2 0 1 2", "0 1 2 0.5 1.5 2.5"), "1 1 1", "0 0 0"),
        {"quadrilateral 0", "area zero"}},
       {"folded", "1\n3 2\n0 1 0.5 0 1 0.5\n0 0 0\n1 1 1\n", {"quadrilateral"}}},
      parse);
}

TEST_CASE("plot3d_bad_maps_are_refused_with_line") {
  const std::string grid = format({c_grid()});
  check_refused(
      {{"blocks", replaced(c_map, "\n1\n1 13", "\n2\n1 13"), {"m.nmf:2", "2 blocks, the grid 1"}},
       {"size", replaced(c_map, "13 3 1\n", "13 4 1\n"), {"m.nmf:3", "13 by 3 points"}},
       {"block",
        replaced(c_map, "'outflow' 1 1", "'outflow' 2 1"),
        {"m.nmf:7", "found 2", "number of a block"}},
       {"face", replaced(c_map, "'outflow' 1 1", "'outflow' 1 5"), {"m.nmf:7", "found 5", "from 1 to 4"}},
       {"range", replaced(c_map, "1 3 4 10", "1 3 4 14"), {"m.nmf:6", "points 4 to 14", "13 points"}},
       {"lengths", replaced(c_map, "1 3 13 10", "1 3 13 11"), {"m.nmf:5", "4 points is joined to one of 3"}},
       {"turned", replaced(c_map, "1 3 13 10", "1 3 10 13"), {"m.nmf:5", "farther apart"}},
       {"cut short", c_map.substr(0, c_map.size() - 6), {"m.nmf:9", "number of a point"}},
       {"twice", c_map + "'wall' 1 4 3 4 1 1\n", {"comes a second time"}}},
      [&](const std::string& map) { return parse_mapped(grid, map); });
}

TEST_CASE("plot3d_map_beside_the_file_is_read_with_it") {
  const Folder folder;
  std::ofstream(folder.path / "c.p2dfmt") << format({c_grid()});
  CHECK(edges_named(io::read_plot3d(folder.path / "c.p2dfmt").mesh, "j_max") == 12);
  std::ofstream(folder.path / "c.nmf") << c_map;
  CHECK(edges_named(io::read_mixed_mesh<2>(folder.path / "c.p2dfmt").mesh, "farfield") == 12);
  CHECK(refusal([&] { (void)io::read_mixed_mesh<3>(folder.path / "c.p2dfmt"); }).find("known are .su2") !=
        std::string::npos);
}
