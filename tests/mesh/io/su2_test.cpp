// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/su2.hpp"

#include <fstream>
#include <sstream>

#include "leonhard/mesh/exact_area.hpp"
#include "tests/mesh/io/sample_meshes.hpp"
#include "tests/test_files.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

/// Two triangles on the unit square.
const std::string square =
    "NDIME= 2\n"
    "NELEM= 2\n"
    "5 0 1 2 0\n"
    "5 0 2 3 1\n"
    "NPOIN= 4\n"
    "0 0 0\n"
    "1 0 1\n"
    "1 1 2\n"
    "0 1 3\n"
    "NMARK= 2\n"
    "MARKER_TAG= wall\n"
    "MARKER_ELEMS= 1\n"
    "3 0 1\n"
    "MARKER_TAG= farfield\n"
    "MARKER_ELEMS= 3\n"
    "3 1 2\n"
    "3 2 3\n"
    "3 3 0\n";

MeshFile parse(const std::string& text) { return io::parse_su2(text, "m.su2"); }

/// One quadrilateral with the given corners in the order of the cell.
std::string quadrilateral(const std::string& points, const std::string& corners = "0 1 2 3") {
  return "NDIME= 2\nNELEM= 1\n9 " + corners + "\nNPOIN= 4\n" + points +
         "NMARK= 1\nMARKER_TAG= b\nMARKER_ELEMS= 4\n3 0 1\n3 1 2\n3 2 3\n3 3 0\n";
}

}  // namespace

TEST_CASE("su2_round_trip_keeps_points_triangles_boundary_marker_numbers_and_names") {
  const TriangleMesh mesh = grid_with_hole();
  const MeshFile back = parse(io::format_su2(mesh));
  check_same_mesh(mesh, back.mesh);
  CHECK(back.warnings.empty());
  CHECK(io::format_su2(back.mesh) == io::format_su2(mesh));
}

TEST_CASE("su2_markers_without_a_name_stay_nameless_and_keep_their_number") {
  TriangleMesh mesh = grid_with_hole();
  mesh.marker_names.erase(7);
  const std::string text = io::format_su2(mesh);
  CHECK(text.find("MARKER_TAG= marker_7\n") != std::string::npos);
  check_same_mesh(mesh, parse(text).mesh);
}

TEST_CASE("su2_markers_of_other_programs_are_numbered_in_file_order_from_1") {
  const TriangleMesh mesh = parse(square).mesh;
  CHECK(mesh.marker_names == std::map<Marker, std::string>{{1, "wall"}, {2, "farfield"}});
  CHECK(std::count_if(mesh.boundary.begin(), mesh.boundary.end(), [](auto& e) { return e.marker == 2; }) ==
        3);
}

TEST_CASE("su2_sections_may_come_in_any_order_with_comments_blank_lines_and_dos_line_ends") {
  const std::string shuffled =
      "% a comment\r\n\r\n  NMARK = 1 % two words\r\nMARKER_TAG= \"all\"\r\nMARKER_ELEMS=4\r\n3\t0\t1\t0\r\n "
      "3 2 1\r\n3 2 3\r\n3 0 3\r\n"
      "NPOIN=4 4\r\n0 0 0 0\r\n+1 0 1 1\r\n1 1.0 2 2\r\n0.0e0 1E+0 3 3 % last\r\nNELEM=2\r\n5 0 1 2\r\n5 0 2 "
      "3\r\nNDIME=2";
  const MeshFile file = parse(shuffled);
  CHECK(file.warnings.empty());
  CHECK(file.mesh.marker_names.at(1) == "all");
  CHECK(mesh::fingerprint(file.mesh) == mesh::fingerprint(parse(square).mesh));
}

TEST_CASE("su2_file_in_tests_data_is_read_and_its_area_is_exact") {
  const MeshFile file = io::read_su2(test::data_file("square_with_hole.su2"));
  CHECK(file.warnings.empty());
  CHECK(file.mesh.marker_names == std::map<Marker, std::string>{{1, "hole"}, {2, "outer"}});
  CHECK(mesh::exact_area2(file.mesh) == 2 * (16 - 4));
}

TEST_CASE("quadrilateral_is_split_along_its_delaunay_diagonal") {
  // The circle through (0,0), (1,0), (1,1) does not reach (0, 1.5), so the diagonal 0-2 is Delaunay; it holds (0, 0.5).
  const TriangleMesh far = parse(quadrilateral("0 0\n1 0\n1 1\n0 1.5\n")).mesh;
  CHECK(far.corners[TriangleId{0}] == std::array{VertexId{0}, VertexId{1}, VertexId{2}});
  CHECK_FALSE(mesh::validate_delaunay(far));
  const TriangleMesh near = parse(quadrilateral("0 0\n1 0\n1 1\n0 0.5\n")).mesh;
  CHECK(near.corners[TriangleId{0}] == std::array{VertexId{1}, VertexId{2}, VertexId{3}});
  CHECK_FALSE(mesh::validate_delaunay(near));
}

TEST_CASE("cocircular_quadrilateral_is_split_the_same_way_whatever_corner_it_starts_with") {
  const auto reference = mesh::fingerprint(parse(quadrilateral("0 0\n1 0\n1 1\n0 1\n")).mesh);
  for (const char* corners : {"1 2 3 0", "2 3 0 1", "3 0 1 2", "3 2 1 0", "2 1 0 3"}) {
    const MeshFile file = parse(quadrilateral("0 0\n1 0\n1 1\n0 1\n", corners));
    CHECK(mesh::fingerprint(file.mesh) == reference);
    CHECK(file.warnings.back().find("1 quadrilaterals were split") != std::string::npos);
  }
}

TEST_CASE("quadrilateral_with_a_reflex_corner_is_split_at_that_corner") {
  for (const char* points :
       {"0 0\n2 0\n0.5 0.5\n0 2\n", "0 0\n2 0\n1 1\n0 2\n"}) {  // the second: a straight corner
    const TriangleMesh mesh = parse(quadrilateral(points)).mesh;
    CHECK(mesh.corners[TriangleId{0}] == std::array{VertexId{0}, VertexId{1}, VertexId{2}});
  }
}

TEST_CASE("clockwise_triangles_are_turned_over_with_a_warning_only_if_all_are") {
  const MeshFile file = parse(replaced(replaced(square, "5 0 1 2", "5 2 1 0"), "5 0 2 3", "5 3 2 0"));
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("all 2 triangles are clockwise") != std::string::npos);
  CHECK(mesh::fingerprint(file.mesh) == mesh::fingerprint(parse(square).mesh));
}

TEST_CASE("su2_section_of_another_program_is_skipped_with_a_warning") {
  const MeshFile file = parse(square + "FFD_NBOX= 1\n1 2 3\nsome words\n");
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("m.su2:19: the section FFD_NBOX=") != std::string::npos);
}

TEST_CASE("su2_bad_input_is_refused_with_line_and_ids") {
  const std::vector<BadInput> table{
      {"empty", "", {"m.su2"}},
      {"only comments", "% nothing\n", {"m.su2", "NDIME="}},
      {"3-D", replaced(square, "NDIME= 2", "NDIME= 3"), {"m.su2:1", "NDIME= 3", "plane"}},
      {"id out of range",
       replaced(square, "5 0 2 3 1", "5 0 2 9 1"),
       {"m.su2:4", "triangle 1", "vertex 9", "0 to 3"}},
      {"negative id", replaced(square, "5 0 2 3 1", "5 0 2 -3 1"), {"m.su2:4", "-3", "numbered from 0"}},
      {"id beyond 32 bits", replaced(square, "5 0 2 3 1", "5 0 2 99999999999 1"), {"m.su2:4", "99999999999"}},
      {"unknown cell type", replaced(square, "5 0 1 2", "12 0 1 2"), {"m.su2:3", "cell 0", "type 12"}},
      {"missing cell", replaced(replaced(square, "NELEM= 2", "NELEM= 1"), "5 0 2 3 1\n", ""), {"m.su2", "3"}},
      {"marked no edge", replaced(square, "3 3 0\n", "3 3 1\n"), {"m.su2", "(0, 1)", "(1, 0)"}},
      {"edge id out of range",
       replaced(square, "3 3 0\n", "3 3 4\n"),
       {"m.su2", "3-4", "vertex 4", "0 to 3"}},
      {"edge marked twice",
       replaced(replaced(square, "3 3 0\n", "3 3 0\n3 0 1\n"), "ELEMS= 3", "ELEMS= 4"),
       {"m.su2", "0-1", "second time"}},
      {"zero area",
       replaced(square, "1 1 2\n", "0.5 0 2\n"),
       {"m.su2:3", "triangle 0", "area zero", "(0.5, 0)"}},
      {"repeated corner",
       replaced(square, "5 0 1 2", "5 0 1 1"),
       {"m.su2:3", "triangle 0", "vertex 1 twice"}},
      {"NaN", replaced(square, "1 1 2\n", "1 nan 2\n"), {"m.su2:8", "\"nan\" is not finite", "y coordinate"}},
      {"infinity", replaced(square, "1 1 2\n", "-inf 1 2\n"), {"m.su2:8", "\"-inf\" is not finite"}},
      {"too large", replaced(square, "1 1 2\n", "1e999 1 2\n"), {"m.su2:8", "1e999", "range of double"}},
      {"letters", replaced(square, "1 1 2\n", "1 l 2\n"), {"m.su2:8", "\"l\"", "y coordinate"}},
      {"hexadecimal", replaced(square, "1 1 2\n", "1 0x1p0 2\n"), {"m.su2:8", "\"0x1p0\""}},
      {"3-D point",
       replaced(replaced(square, "1 0 1\n", "1 0 0.25 1\n"), "1 1 2\n", "1 1 0.5 2\n"),
       {"m.su2:8", "third coordinate 0.5", "0.25"}},
      {"one coordinate", replaced(square, "1 1 2\n", "1\n"), {"m.su2:8", "line ends", "y coordinate"}},
      {"cut in cells", square.substr(0, square.find("5 0 2 3 1")), {"m.su2:2", "number of cells"}},
      {"cut in points",
       square.substr(0, square.find("1 1 2")) + "      ",
       {"m.su2:8", "file ends where point 3 of 4"}},
      {"cut before markers", square.substr(0, square.find("NMARK")), {"m.su2", "NMARK=", "cut short"}},
      {"cut between markers",
       square.substr(0, square.find("MARKER_TAG= far")),
       {"NMARK= declares 2", "has 1", "cut short"}},
      {"too few cells", replaced(square, "NELEM= 2", "NELEM= 3"), {"m.su2:5", "NPOIN= 4", "cell 3 of 3"}},
      {"too many cells", replaced(square, "NELEM= 2", "NELEM= 1"), {"m.su2:4", "5 0 2 3 1", "keyword"}},
      {"a count of 10^12",
       replaced(square, "NPOIN= 4", "NPOIN= 1000000000000"),
       {"m.su2:5", "1000000000000", "cannot hold"}},
      {"a count of 10^30",
       replaced(square, "NELEM= 2", "NELEM= 1000000000000000000000000000000"),
       {"m.su2:2", "too large"}},
      {"negative count", replaced(square, "NELEM= 2", "NELEM= -2"), {"m.su2:2", "-2", "negative"}},
      {"no cells", "NDIME= 2\nNELEM= 0\nNPOIN= 1\n0 0\nNMARK= 0\n", {"m.su2", "no cells of the plane"}},
      {"no points", "NDIME= 2\nNELEM= 0\nNPOIN= 0\nNMARK= 0\n", {"m.su2", "no points"}},
      {"duplicate marker",
       replaced(square, "farfield", "wall"),
       {"m.su2:14", "\"wall\" comes a second time"}},
      {"marker without name", replaced(square, "farfield", ""), {"m.su2:14", "no name"}},
      {"marker without elements",
       replaced(square, "MARKER_ELEMS= 3\n", ""),
       {"m.su2:15", "3 1 2", "MARKER_ELEMS="}},
      {"mistyped keyword",
       replaced(square, "NPOIN=", "NPION="),
       {"m.su2:5", "NPION=", "did you mean \"NPOIN\"?"}},
      {"section twice", square + "NDIME= 2\n", {"m.su2:19", "NDIME= comes a second time"}},
      {"several zones", "NZONE= 2\n" + square, {"m.su2", "declares 2 zones, but the file has 0"}},
      {"binary", std::string("NDIME= 2\n\0\0", 11), {"m.su2:2", "zero byte"}},
      {"crossed quadrilateral",
       quadrilateral("0 0\n1 1\n1 0\n0 1\n"),
       {"m.su2:3", "quadrilateral 0", "crosses itself"}},
      {"flat quadrilateral",
       quadrilateral("0 0\n1 0\n2 0\n3 0\n"),
       {"m.su2:3", "quadrilateral 0", "zero area"}}};
  check_refused(table, parse);
}

TEST_CASE("su2_mesh_that_overlaps_itself_is_refused_though_every_cell_is_positive") {
  // A fan of 7 triangles that winds about the origin twice: every cell is counter-clockwise, every edge fits.
  std::ostringstream text;
  text << "NDIME= 2\nNELEM= 7\n";
  for (int i = 0; i < 7; ++i) text << "5 0 " << i + 1 << " " << (i + 1) % 7 + 1 << "\n";
  text << "NPOIN= 8\n0 0\n";
  const char* star[] = {"10 0", "-2 9", "-9 -4", "6 -8", "6 8", "-9 4", "-2 -9"};
  for (const char* point : star) text << point << "\n";
  text << "NMARK= 1\nMARKER_TAG= rim\nMARKER_ELEMS= 7\n";
  for (int i = 0; i < 7; ++i) text << "3 " << i + 1 << " " << (i + 1) % 7 + 1 << "\n";
  CHECK(refusal([&] { parse(text.str()); }).find("m.su2: the mesh is tangled") == 0);
}

TEST_CASE("every_prefix_of_an_su2_file_is_refused") {
  const std::string text = io::format_su2(grid_with_hole());
  for (std::size_t length = 0; length + 1 < text.size(); ++length)
    CHECK_MESSAGE(refusal([&] { parse(text.substr(0, length)); }) != "accepted", "cut after byte ", length);
}

TEST_CASE("su2_writer_refuses_names_that_the_format_cannot_carry") {
  TriangleMesh mesh = grid_with_hole();
  for (const char* name : {"", "two words", "50%", "farfield", "tab\there", "line\nbreak"}) {
    mesh.marker_names[3] = name;
    CHECK(refusal([&] { static_cast<void>(io::format_su2(mesh)); }).find("marker ") == 0);
  }
}
