// SPDX-License-Identifier: MIT
#include <type_traits>

#include "leonhard/mesh/io/formats/gmsh.hpp"
#include "tests/mesh/io/mixed_samples.hpp"
#include "tests/mesh/io/sample_tet_meshes.hpp"
#include "tests/mesh/shelf.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

using Plane = std::integral_constant<int, 2>;
using Space = std::integral_constant<int, 3>;

constexpr std::array all_forms{
    io::GmshForm{io::GmshVersion::v2_2, false}, io::GmshForm{io::GmshVersion::v2_2, true},
    io::GmshForm{io::GmshVersion::v4_1, false}, io::GmshForm{io::GmshVersion::v4_1, true}};

/// A pyramid on a cube with a node too many, as Gmsh writes them.
const std::string house =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"floor\"\n3 4 "
    "\"fluid\"\n$EndPhysicalNames\n$Nodes\n10\n1 "
    "0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n9 5 5 5\n10 0.5 0.5 2\n$EndNodes\n"
    "$Elements\n5\n1 15 2 0 1 9\n2 3 2 7 1 1 2 3 4\n3 2 2 8 2 5 6 10\n4 7 2 4 1 5 6 7 8 10\n5 5 2 4 1 1 2 3 "
    "4 5 6 7 "
    "8\n$EndElements\n";

MixedMeshFile<3> parse(const std::string& text) { return io::parse_mixed_gmsh<3>(text, "m.msh"); }

}  // namespace

TEST_CASE_TEMPLATE("msh_meshes_of_mixed_cells_come_back_in_every_form", Dim, Plane, Space) {
  for (const auto& entry : mixed_shelf::all<Dim::value>()) {
    CAPTURE(entry.name);
    auto mesh = with_everything(mixed_shelf::shaken(entry.mesh, 6), 3, 1);
    for (auto& marker : mesh.vertex_markers) marker = 0;  // the format has no place for them
    std::vector<double> heights, heats;
    for (const auto& p : mesh.points) heights.push_back(p.y);
    for (const CellId cell : mesh.kinds.ids()) heats.push_back(0.1 * static_cast<double>(cell.index()));
    const std::vector<PointField> points{{"height", 1, heights}};
    const std::vector<CellField> cells{{"heat", 1, heats}};
    for (const io::GmshForm& form : all_forms) {
      CAPTURE(form.binary);
      CAPTURE(static_cast<int>(form.version));
      const auto file = io::parse_mixed_gmsh<Dim::value>(io::format_gmsh(mesh, form, points, cells), "m.msh");
      CHECK(file.warnings.empty());
      CHECK(file.mesh == mesh);
      CHECK(file.point_fields == points);
      CHECK(file.cell_fields == cells);
    }
  }
}

TEST_CASE("msh_files_of_tetrahedra_are_read_as_mixed_cells_and_the_other_way_round") {
  TetMesh mesh = box_with_everything();
  for (auto& marker : mesh.vertex_markers) marker = 0;
  CHECK(parse(io::format_gmsh(mesh)).mesh == mesh::mixed_mesh_of(mesh));
  for (const io::GmshForm& form : all_forms)
    CHECK(io::format_gmsh(mesh::mixed_mesh_of(mesh), form) == io::format_gmsh(mesh, form));
}

TEST_CASE("msh_cells_of_other_programs_are_taken_in_the_order_of_their_numbers") {
  const MixedMeshFile<3> file = parse(house);
  CHECK(file.mesh.kinds.flat() == std::vector{CellKind::pyramid, CellKind::hexahedron});
  CHECK(file.mesh.vertex_count() == 9);
  CHECK(file.mesh.regions.flat() == std::vector<double>{4, 4});
  CHECK(file.mesh.marker_names == std::map<Marker, std::string>{{1, "unmarked"}, {7, "floor"}});
  CHECK(file.mesh.region_names.size() == 1);
  CHECK(file.mesh.boundary[0] ==
        MarkedMixedFacet<3>{{VertexId{0}, VertexId{3}, VertexId{2}, VertexId{1}}, 7});
  CHECK(file.mesh.boundary[1] == MarkedMixedFacet<3>{{VertexId{4}, VertexId{5}, VertexId{8}}, 8});
  CHECK(file.mesh.boundary.back().marker == 1);
  REQUIRE(file.warnings.size() == 2);
  CHECK(file.warnings[0].find("1 vertex that no cell uses was left out") == 0);
  CHECK(file.warnings[1].find("7 of 9 boundary faces have no marker") == 0);
}

TEST_CASE("msh_bad_meshes_of_mixed_cells_are_refused") {
  check_refused(
      {{"second order", replaced(house, "5 5 2 4 1 1", "5 77 2 4 1 1"), {"type 77"}},
       {"node", replaced(house, "5 6 7 8 10\n", "5 6 7 8 11\n"), {"names node 11"}},
       {"flat",
        replaced(house, "10 0.5 0.5 2", "10 0.5 0.5 1"),
        {"m.msh:27: pyramid 0 (vertices 4, 5", "volume zero"}},
       {"twice",
        replaced(house, "1 2 3 4 5 6 7 8\n", "1 2 3 4 5 6 7 7\n"),
        {"m.msh:28", "vertex 6 twice", "from 0"}},
       {"inverted", replaced(house, "10 0.5 0.5 2", "10 0.5 0.5 0.5"), {"same side of face 4-5-6-7"}}},
      parse);
  CHECK(refusal([] { (void)io::parse_mixed_gmsh<2>(house, "m.msh"); }).find("cells of space") !=
        std::string::npos);
  CHECK(refusal([] { (void)io::parse_tet_gmsh(house, "m.msh"); }).find("m.msh:27: the file has pyramids") ==
        0);
  CHECK(refusal([] { (void)parse(io::format_gmsh(shelf::grid(2, 2))); }).find("no cells of space") !=
        std::string::npos);
}
