// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/su2.hpp"
#include "tests/mesh/io/sample_tet_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

const std::string one =
    "NDIME= 3\nNELEM= 1\n10 0 1 2 3 0\nNPOIN= 4\n0 0 0 0\n1 0 0 1\n0 1 0 2\n0 0 1 3\nNMARK= 2\n"
    "MARKER_TAG= wall\nMARKER_ELEMS= 1\n5 0 1 2\nMARKER_TAG= farfield\nMARKER_ELEMS= 3\n5 0 1 3 0\n5 1 2 "
    "3\n5 2 0 3\n";

TetMeshFile parse(const std::string& text) { return io::parse_tet_su2(text, "m.su2"); }

}  // namespace

TEST_CASE("su2_mesh_of_space_is_read_and_comes_back") {
  const TetMeshFile file = parse(one);
  CHECK(file.warnings.empty());
  CHECK(file.mesh.marker_names == std::map<Marker, std::string>{{1, "wall"}, {2, "farfield"}});
  CHECK(file.mesh.boundary[0] == MarkedFace{{VertexId{0}, VertexId{2}, VertexId{1}}, 1});
  const TetMeshFile again = parse(io::format_su2(file.mesh));
  CHECK(again.warnings.empty());
  CHECK(again.mesh == file.mesh);
}

TEST_CASE("su2_mesh_of_space_with_nameless_and_negative_markers_comes_back") {
  TetMesh mesh = tet_shelf::shaken_box(2, 3);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    mesh.boundary[i].marker = static_cast<Marker>(i % 5) - 2;
  mesh.marker_names = {{1, "wall"}, {-2, "inlet"}};
  check_same_geometry_and_boundary(mesh, parse(io::format_su2(mesh)).mesh);
}

TEST_CASE("su2_bad_meshes_of_space_are_refused_with_line_and_ids") {
  check_refused(
      {{"plane", replaced(one, "NDIME= 3", "NDIME= 2"), {"m.su2:1", "NDIME= 2", "space"}},
       {"hexahedron", replaced(one, "10 0 1 2 3", "12 0 1 2 3"), {"m.su2:3", "a vertex of the cell"}},
       {"triangle", replaced(one, "10 0 1 2 3", "5 0 1 2"), {"m.su2:3", "type 5"}},
       {"range", replaced(one, "10 0 1 2 3", "10 0 1 2 4"), {"m.su2:3", "vertex 4", "0 to 3"}},
       {"flat", replaced(one, "0 0 1 3\n", "1 1 0 3\n"), {"m.su2:3", "volume zero"}},
       {"NaN", replaced(one, "0 0 1 3\n", "0 0 nan 3\n"), {"m.su2:8", "z coordinate"}},
       {"two columns", replaced(one, "0 0 1 3\n", "0 0\n"), {"m.su2:8", "z coordinate"}},
       {"line in marker", replaced(one, "5 0 1 2", "3 0 1"), {"m.su2:12", "type 3", "triangles"}},
       {"face range", replaced(one, "5 1 2 3", "5 1 2 7"), {"m.su2:16", "vertex 7"}},
       {"face twice", replaced(one, "5 1 2 3", "5 1 2 0"), {"m.su2:16", "second time", "line 12"}},
       {"cut short", one.substr(0, one.find("5 2 0 3")), {"m.su2", "boundary element 3 of 3"}}},
      parse);
  CHECK(refusal([&] { (void)io::parse_su2(one, "m.su2"); }).find("m.su2:1: NDIME= 3") == 0);
}
