// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/medit.hpp"

#include "tests/mesh/io/sample_tet_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

/// Two tetrahedra; the face between them is marked, two boundary faces are not.
const std::string two =
    "MeshVersionFormatted 1\n"
    "Dimension\n3\n"
    "Vertices\n5\n"
    "0 0 0 1\n"
    "1 0 0 2\n"
    "0 1 0 3\n"
    "0 0 1 4\n"
    "1 1 1 5\n"
    "Triangles 5\n"
    "1 3 2 7\n"
    "1 2 4 7\n"
    "1 3 4 7\n"
    "2 3 4 -9\n"
    "2 3 5 0\n"
    "Tetrahedra\n2\n"
    "1 2 3 4 6\n"
    "2 3 4 5 -6\n"
    "End\n";

TetMeshFile parse(const std::string& text) { return io::parse_medit(text, "m.mesh"); }

}  // namespace

TEST_CASE("medit_round_trip_keeps_everything") {
  const TetMesh mesh = box_with_everything();
  const std::string text = io::format_medit(mesh);
  const TetMeshFile back = parse(text);
  CHECK(back.warnings.empty());
  CHECK(back.mesh == mesh);
  CHECK(io::format_medit(back.mesh) == text);
}

TEST_CASE("medit_references_are_markers_and_regions") {
  const TetMeshFile file = parse(two);
  CHECK(file.mesh.vertex_markers.flat() == std::vector<Marker>{1, 2, 3, 4, 5});
  CHECK(file.mesh.regions.flat() == std::vector<double>{6, -6});
  CHECK(file.mesh.interfaces == std::vector<MarkedFace>{{{VertexId{1}, VertexId{2}, VertexId{3}}, -9}});
  REQUIRE(file.mesh.boundary.size() == 6);
  CHECK(file.mesh.boundary[2] == MarkedFace{{VertexId{0}, VertexId{3}, VertexId{2}}, 7});  // turned outwards
  CHECK(file.mesh.boundary[3].marker == 0);
  CHECK(file.mesh.boundary[4].marker == 1);
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("2 of 6 boundary faces") == 0);
}

TEST_CASE("medit_sections_may_come_in_any_order_and_entries_span_lines") {
  const std::string tets = "Tetrahedra\n2\n1 2 3 4 6\n2 3 4 5 -6\n";
  const std::string shuffled =
      "# by hand\r\n" + tets + replaced(replaced(two, tets, ""), "0 0 1 4\n", "0 0\n1 4 ");
  CHECK(parse(shuffled).mesh == parse(two).mesh);
}

TEST_CASE("harmless_medit_sections_are_passed_over_with_a_warning_if_they_hold_anything") {
  const std::string text =
      replaced(two, "Tetrahedra",
               "Edges\n2\n1 2 5\n2 3 5\nCorners 3\n1 2 3\nRidges\n0\nNormals\n1\n0 0 1.5\n"
               "NormalAtVertices 1\n1 1\nTetrahedra");
  const TetMeshFile file = parse(text);
  CHECK(file.mesh == parse(two).mesh);
  REQUIRE(file.warnings.size() == 5);
  CHECK(file.warnings[0] == "m.mesh:21: the section Corners (3 entries) was passed over");
  CHECK(std::count(file.warnings.begin(), file.warnings.end(),
                   "the section Edges (2 entries) was passed over") == 1);
}

TEST_CASE("medit_bad_input_is_refused_with_its_line") {
  check_refused(
      {{"empty", "\n", {"m.mesh", "MeshVersionFormatted"}},
       {"plane", "MeshVersionFormatted 1\nDimension 2\nVertices 0\n", {"m.mesh", "Dimension 2", "space"}},
       {"dimension", replaced(two, "\n3\nVertices", "\n4\nVertices"), {"m.mesh:3", "Dimension 4"}},
       {"no tetrahedra",
        replaced(two, "Tetrahedra\n2\n1 2 3 4 6\n2 3 4 5 -6\n", ""),
        {"m.mesh", "no cells of space"}},
       {"NaN", replaced(two, "1 0 0 2", "1 nan 0 2"), {"m.mesh:7", "nan", "not finite"}},
       {"three columns", replaced(two, "1 0 0 2\n", "1 0 0\n"), {"m.mesh:11", "\"Triangles\""}},
       {"vertex 0", replaced(two, "1 2 3 4 6", "0 2 3 4 6"), {"m.mesh:19", "vertex 0", "from 1"}},
       {"range",
        replaced(two, "1 2 3 4 6", "1 2 3 6 6"),
        {"m.mesh:19", "tetrahedron 0 names vertex 5", "0 to 4", "in the file from 1"}},
       {"range of a face", replaced(two, "1 2 4 7", "1 2 6 7"), {"m.mesh:13", "vertex 5"}},
       {"face of no tetrahedron", replaced(two, "1 2 4 7", "1 2 5 7"), {"m.mesh", "0-1-4"}},
       {"face twice", replaced(two, "1 2 4 7", "2 3 1 8"), {"m.mesh:13", "second time", "line 12"}},
       {"flat", replaced(two, "1 1 1 5", "1 1 -1 5"), {"m.mesh:20", "has volume zero"}},
       {"hexahedra",
        replaced(two, "End", "Hexahedra\n1\n1 2 3 4 5 6 7 8 0\nEnd"),
        {"m.mesh:23", "hexahedra", "--split"}},
       {"quadrilaterals",
        replaced(two, "End", "Quadrilaterals\n1\n1 2 3 4 0\nEnd"),
        {"m.mesh:23", "4 corners"}},
       {"keyword",
        replaced(two, "Tetrahedra", "Tetrahedrons"),
        {"m.mesh:17", "did you mean \"Tetrahedra\"?"}},
       {"twice", replaced(two, "End", "Vertices 0\nEnd"), {"m.mesh:21", "second time"}},
       {"count", replaced(two, "Tetrahedra\n2", "Tetrahedra\n2000"), {"m.mesh:18", "2000", "cannot hold"}},
       {"negative", replaced(two, "Tetrahedra\n2", "Tetrahedra\n-2"), {"m.mesh:18", "negative"}},
       {"too many", replaced(two, "Tetrahedra\n2", "Tetrahedra\n1"), {"m.mesh:20", "\"2\""}},
       {"reference", replaced(two, "1 2 3 4 6", "1 2 3 4 99999999999"), {"m.mesh:19", "32 bits"}},
       {"binary", std::string("MeshV\0", 6), {"m.mesh:1", "zero byte"}}},
      parse);
}

TEST_CASE("every_prefix_of_a_medit_file_is_refused_before_its_last_section_is_whole") {
  const std::string text = io::format_medit(two_tets());
  for (std::size_t length = 0; length + 8 < text.size(); ++length)
    CHECK_MESSAGE(refusal([&] { parse(text.substr(0, length)); }) != "accepted", "cut after byte ", length);
}
