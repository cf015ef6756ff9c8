// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/vtu.hpp"
#include "tests/mesh/io/sample_tet_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

/// One tetrahedron with a triangle and a line, as other programs write them.
const std::string one =
    "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"><UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"3\">\n"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n"
    "0 0 0 1 0 0 0 1 0 0 0 1\n"
    "</DataArray></Points>\n"
    "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 1 2 3 0 1</DataArray>\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 7 9</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 10 3</DataArray></Cells>\n"
    "<CellData><DataArray type=\"Int32\" Name=\"gmsh:physical\" format=\"ascii\">4 0 "
    "0</DataArray></CellData>\n"
    "</Piece></UnstructuredGrid></VTKFile>\n";

TetMeshFile parse(const std::string& text) { return io::parse_tet_vtu(text, "m.vtu"); }

}  // namespace

TEST_CASE("vtu_of_space_keeps_everything") {
  TetMesh mesh = box_with_everything();
  mesh.regions[TetId{3}] = -0.1;
  mesh.interfaces.push_back({mesh.interfaces.front().corners, 0});
  std::swap(mesh.interfaces.back().corners[0], mesh.interfaces.back().corners[1]);
  const std::vector<PointField> fields{{"mach", 1, std::vector<double>(mesh.vertex_count(), 0.5)}};
  const std::vector<CellField> cell_fields{{"stress", 9, std::vector<double>(9 * mesh.tet_count(), 0.1)},
                                           {"drift", 2, std::vector<double>(2 * mesh.tet_count(), -0.0)}};
  const TetMeshFile back = parse(io::format_vtu(mesh, fields, cell_fields));
  CHECK(back.warnings.empty());
  CHECK(back.mesh == mesh);
  CHECK(back.point_fields == fields);
  CHECK(back.cell_fields == cell_fields);
}

TEST_CASE("triangles_of_a_vtu_of_space_mark_faces_and_the_others_get_a_number_of_their_own") {
  const TetMeshFile file = parse(one);
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.mesh.boundary[0] == MarkedFace{{VertexId{0}, VertexId{2}, VertexId{1}}, 4});
  CHECK(std::count_if(file.mesh.boundary.begin(), file.mesh.boundary.end(),
                      [](const MarkedFace& face) { return face.marker == 1; }) == 3);
  CHECK(file.mesh.marker_names == std::map<Marker, std::string>{{1, "unmarked"}});
}

TEST_CASE("vtu_bad_meshes_of_space_are_refused") {
  check_refused(
      {{"hexahedron", replaced(one, ">5 10 3<", ">5 12 3<"), {"m.vtu:6", "type 12", "needs 8"}},
       {"corner count", replaced(one, ">3 7 9<", ">3 6 9<"), {"m.vtu:6", "cell 1 of type 10 has 3"}},
       {"range", replaced(one, "0 1 2 3 0 1<", "0 1 2 4 0 1<"), {"m.vtu:6", "vertex 4", "0 to 3"}},
       {"flat", replaced(one, "0 0 1\n<", "1 1 0\n<"), {"m.vtu", "volume zero"}},
       {"NaN", replaced(one, "0 0 1\n<", "nan 1 0\n<"), {"m.vtu:4", "nan"}},
       {"plane", replaced(one, ">5 10 3<", ">5 9 3<"), {"m.vtu", "no cells of space"}},
       {"offsets", replaced(one, ">3 7 9<", ">3 17 9<"), {"m.vtu:6", "entry 17"}},
       {"no types", replaced(one, "Name=\"types\"", "Name=\"kinds\""), {"m.vtu", "no array \"types\""}},
       {"not a vtu", "<html></html>", {"m.vtu:1", "no unstructured grid"}}},
      parse);
  CHECK(refusal([&] { (void)io::parse_vtu(one, "m.vtu"); }).find("z = ") != std::string::npos);
}
