// SPDX-License-Identifier: MIT
#include <array>
#include <type_traits>

#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/mixed_mesh_file.hpp"
#include "tests/mesh/io/folder.hpp"
#include "tests/mesh/io/sample_tet_meshes.hpp"
#include "tests/mesh/mixed_shelf.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

using Plane = std::integral_constant<int, 2>;
using Space = std::integral_constant<int, 3>;

/// A pyramid on a cube, every corner of the file in the order of SU2's manual.
const std::string house =
    "NDIME= 3\nNELEM= 2\n12 0 1 2 3 4 5 6 7 0\n14 4 5 6 7 8 1\nNPOIN= 9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 "
    "1\n1 0 "
    "1\n1 1 1\n0 1 1\n0.5 0.5 2\nNMARK= 2\nMARKER_TAG= wall\nMARKER_ELEMS= 5\n9 0 1 2 3\n9 0 1 5 4\n9 1 2 6 "
    "5\n9 "
    "2 3 7 6\n9 3 0 4 7\nMARKER_TAG= roof\nMARKER_ELEMS= 4\n5 4 5 8\n5 5 6 8\n5 6 7 8\n5 7 4 8\n";

const std::string strip =
    "NDIME= 2\nNELEM= 2\n9 0 1 2 3\n5 1 4 2\nNPOIN= 5\n0 0\n1 0\n1 1\n0 1\n2 0.5\nNMARK= 1\nMARKER_TAG= "
    "wall\nMARKER_ELEMS= 5\n3 0 1\n3 1 4\n3 4 2\n3 2 3\n3 3 0\n";

MixedMeshFile<3> parse(const std::string& text) { return io::parse_mixed_su2<3>(text, "m.su2"); }
MixedMeshFile<2> parse_plane(const std::string& text) { return io::parse_mixed_su2<2>(text, "m.su2"); }

/// Markers that tell the boundary's facets apart, two of them named.
template <int Dim>
MixedMesh<Dim> with_markers(MixedMesh<Dim> mesh) {
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    mesh.boundary[i].marker = static_cast<Marker>(4 * i / mesh.boundary.size()) - 1;
  mesh.marker_names = {{-1, "wall"}, {2, "farfield"}};
  return mesh;
}

}  // namespace

TEST_CASE_TEMPLATE("su2_meshes_of_mixed_cells_come_back", Dim, Plane, Space) {
  for (const auto& entry : mixed_shelf::all<Dim::value>()) {
    CAPTURE(entry.name);
    auto mesh = with_markers(mixed_shelf::shaken(entry.mesh, 6));
    const auto file = io::parse_mixed_su2<Dim::value>(io::format_su2(mesh), "m.su2");
    CHECK(file.warnings.empty());
    CHECK(file.mesh.points == mesh.points);
    CHECK(file.mesh.kinds == mesh.kinds);
    CHECK(file.mesh.corners == mesh.corners);
    CHECK(file.mesh.boundary == mesh.boundary);
    const auto again = io::parse_mixed_su2<Dim::value>(io::format_su2(file.mesh), "m.su2");
    CHECK(again.mesh == file.mesh);
  }
}

TEST_CASE("su2_cells_and_faces_of_space_are_read_as_the_file_has_them") {
  const MixedMeshFile<3> file = parse(house);
  CHECK(file.warnings.empty());
  CHECK(file.mesh.kinds.flat() == std::vector{CellKind::hexahedron, CellKind::pyramid});
  CHECK(file.mesh.marker_names == std::map<Marker, std::string>{{1, "wall"}, {2, "roof"}});
  // The file's first face turns inwards.
  CHECK(file.mesh.boundary[0] ==
        MarkedMixedFacet<3>{{VertexId{0}, VertexId{3}, VertexId{2}, VertexId{1}}, 1});
  CHECK(file.mesh.boundary[8] == MarkedMixedFacet<3>{{VertexId{7}, VertexId{4}, VertexId{8}}, 2});
}

TEST_CASE("su2_cells_of_a_kind_that_are_all_turned_over_are_turned_back_and_told") {
  const auto file = parse(replaced(house, "14 4 5 6 7 8", "14 4 7 6 5 8"));
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0] == "all 1 pyramids are inverted in the file; they were turned over");
  CHECK(file.mesh == parse(house).mesh);
  const auto cube = parse(replaced(house, "12 0 1 2 3 4 5 6 7", "12 4 5 6 7 0 1 2 3"));
  CHECK(cube.warnings.size() == 1);
  CHECK(cube.mesh.boundary == parse(house).mesh.boundary);
  const auto plane = parse_plane(replaced(strip, "5 1 4 2", "5 2 4 1"));
  REQUIRE(plane.warnings.size() == 1);
  CHECK(plane.warnings[0] == "all 1 triangles are clockwise in the file; they were turned over");

  MixedMesh<3> prisms = mixed_shelf::box(1, 2, 2, mixed_shelf::Filling::prisms);
  const MixedMesh<3> upright = prisms;
  for (const CellId cell : prisms.kinds.ids()) {
    const auto row = prisms.corners[cell.index()];
    std::swap(row[1], row[2]), std::swap(row[4], row[5]);
  }
  const auto turned = parse(io::format_su2(prisms));
  CHECK(turned.warnings.size() == 1);
  CHECK(turned.mesh.corners == upright.corners);
}

TEST_CASE("su2_quadrilaterals_stay_whole_among_mixed_cells") {
  const MixedMesh<2> mesh = parse_plane(strip).mesh;
  CHECK(mesh.kinds.flat() == std::vector{CellKind::quadrilateral, CellKind::triangle});
  CHECK(io::parse_su2(strip, "m.su2").mesh.triangle_count() == 3);
}

TEST_CASE("su2_bad_meshes_of_mixed_cells_of_space_are_refused_with_line_and_ids") {
  const std::string flat = replaced(house, "0.5 0.5 2\n", "0.5 0.5 1\n");
  check_refused(
      {{"plane", replaced(house, "NDIME= 3", "NDIME= 2"), {"m.su2:1", "NDIME= 2", "space"}},
       {"unknown type", replaced(house, "14 4 5", "15 4 5"), {"m.su2:4", "cell 1 has the type 15", "prism"}},
       {"cell of the plane",
        replaced(house, "14 4 5 6 7 8 1", "9 4 5 6 7"),
        {"m.su2:4", "type 9, which is no"}},
       {"too few", replaced(house, "14 4 5 6 7 8 1", "14 4 5 6 7"), {"m.su2:4", "a vertex of the cell"}},
       {"range",
        replaced(house, "14 4 5 6 7 8", "14 4 5 6 7 9"),
        {"m.su2:4", "pyramid 1", "vertex 9", "0 to 8"}},
       {"twice", replaced(house, "12 0 1 2 3", "12 0 1 2 2"), {"m.su2:3", "hexahedron 0", "vertex 2 twice"}},
       {"flat", flat, {"m.su2:4", "pyramid 1 (vertices 4, 5, 6, 7, 8 at (0, 0, 1)", "volume zero"}},
       {"tangled",
        replaced(house, "12 0 1 2 3 4 5", "12 0 1 2 3 5 4"),
        {"m.su2:3", "is tangled", "vertex 5 at (1, 0, 1)"}},
       {"NaN", replaced(house, "0.5 0.5 2\n", "0.5 nan 2\n"), {"m.su2:14", "y coordinate"}},
       {"line in marker", replaced(house, "5 4 5 8", "3 4 5"), {"m.su2:25", "type 3", "quadrilaterals"}},
       {"face range",
        replaced(house, "5 4 5 8", "5 4 5 17"),
        {"m.su2:25", "marked face 4-5-17", "vertex 17"}},
       {"face with a vertex twice", replaced(house, "5 4 5 8", "5 4 5 5"), {"m.su2:25", "vertex 5 twice"}},
       {"face twice",
        replaced(replaced(house, "9 3 0 4 7", "9 3 0 4 7\n5 4 5 8"), "ELEMS= 5", "ELEMS= 6"),
        {"second time", "markers 1 and 2"}},
       {"half a face",
        replaced(house, "9 0 1 2 3\n", "5 0 1 2\n"),
        {"m.su2", "0-1-2", "is no face of a cell"}},
       {"cell twice",
        replaced(replaced(house, "14 4 5 6 7 8 1", "14 4 5 6 7 8\n14 5 6 7 4 8"), "NELEM= 2", "NELEM= 3"),
        {"m.su2", "pyramid 2 (vertices 5, 6, 7, 4, 8 at", "has the same vertices as pyramid 1"}},
       {"cut short", house.substr(0, house.find("5 7 4 8")), {"m.su2", "boundary element 4 of 4"}}},
      parse);
}

TEST_CASE("su2_cells_of_space_that_do_not_conform_are_refused") {
  // The roof is two tetrahedra, the cube's upper face is not split.
  const std::string split =
      replaced(replaced(house, "14 4 5 6 7 8 1", "10 4 5 6 8\n10 4 6 7 8"), "NELEM= 2", "NELEM= 3");
  check_refused(
      {{"roof of tetrahedra",
        split,
        {"m.su2: face 4-5-6-7 at (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1) of hexahedron 0 meets face ",
         "of tetrahedron ", "three of its vertices: the cells do not conform"}}},
      parse);
}

TEST_CASE("su2_bad_meshes_of_mixed_cells_of_the_plane_are_refused") {
  check_refused(
      {{"space", replaced(strip, "NDIME= 2", "NDIME= 3"), {"m.su2:1", "NDIME= 3", "the plane"}},
       {"cell of space",
        replaced(strip, "5 1 4 2", "10 1 4 2 3"),
        {"m.su2:4", "type 10", "no cell of the plane"}},
       {"not convex", replaced(strip, "0 0\n", "0.75 0.75\n"), {"m.su2:3", "quadrilateral 0", "not convex"}},
       {"straight",
        replaced(strip, "0 0\n", "0.5 0.5\n"),
        {"m.su2:3", "vertex 0 at (0.5, 0.5)", "area zero"}},
       {"crossed", replaced(strip, "9 0 1 2 3", "9 0 1 3 2"), {"m.su2:3", "not convex"}},
       {"overlap",
        replaced(strip, "2 0.5\n", "0.5 0.25\n"),
        {"m.su2", "quadrilateral 0 and triangle 1 lie on the same side of edge 1-2"}},
       {"face in marker", replaced(strip, "3 3 0\n", "5 3 0 1\n"), {"m.su2:18", "type 5", "lines"}}},
      parse_plane);
}

TEST_CASE("mixed_mesh_files_are_written_and_read_by_extension") {
  const Folder folder;
  const MixedMesh<3> mesh = parse(house).mesh;
  const std::vector<PointField> heights{{"height", 1, {0, 0, 0, 0, 1, 1, 1, 1, 2}}};
  for (const std::string& extension : io::mixed_mesh_extensions()) {
    CAPTURE(extension);
    const auto path = folder.path / ("house" + extension);
    io::write_mixed_mesh(path, mesh);
    if (extension != ".mesh") CHECK(io::read_mixed_mesh<3>(path).mesh == mesh);
    CHECK(mesh::fingerprint(io::read_mixed_mesh<3>(path).mesh) == mesh::fingerprint(mesh));
    if (extension == ".su2" || extension == ".mesh") {
      CHECK(refusal([&] { io::write_mixed_mesh(path, mesh, heights); }).find("carry no fields") !=
            std::string::npos);
    } else {
      io::write_mixed_mesh(path, mesh, heights);
      CHECK(io::read_mixed_mesh<3>(path).point_fields == heights);
    }
  }
  CHECK(refusal([&] { io::write_mixed_mesh(folder.path / "house.stl", mesh); }).find(".su2") !=
        std::string::npos);
}
