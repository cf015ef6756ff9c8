// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>
#include <type_traits>

#include "leonhard/mesh/io/formats/vtk_grid.hpp"
#include "leonhard/mesh/io/vtu.hpp"
#include "tests/mesh/io/folder.hpp"
#include "tests/mesh/io/mixed_samples.hpp"
#include "tests/mesh/io/sample_tet_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

using Plane = std::integral_constant<int, 2>;
using Space = std::integral_constant<int, 3>;

/// A pyramid on a cube as other programs write them, its walls marked by two of its nine faces.
const std::string house =
    R"(<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="9" NumberOfCells="5">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 0.5 0.5 2</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">
0 1 2 3 4 5 6 7 4 5 6 7 8 0 1 2 3 4 5 8 0 1</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">8 13 17 20 22</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">12 14 9 5 3</DataArray></Cells>
<CellData><DataArray type="Int32" Name="marker" format="ascii">0 0 7 8 0</DataArray>
<DataArray type="Float64" Name="heat" format="ascii">10 11 12 13 14</DataArray></CellData>
</Piece></UnstructuredGrid></VTKFile>
)";

MixedMeshFile<3> parse(const std::string& text) { return io::parse_mixed_vtu<3>(text, "m.vtu"); }

}  // namespace

TEST_CASE_TEMPLATE("vtu_meshes_of_mixed_cells_come_back_with_all_that_they_carry", Dim, Plane, Space) {
  for (const auto& entry : mixed_shelf::all<Dim::value>()) {
    CAPTURE(entry.name);
    const auto mesh = with_everything(mixed_shelf::shaken(entry.mesh, 6), -1, 0.5);
    std::vector<double> heights, heats;
    for (const auto& p : mesh.points) heights.insert(heights.end(), {p.y, -p.x});
    for (const CellId cell : mesh.kinds.ids()) heats.push_back(0.1 * static_cast<double>(cell.index()));
    const std::vector<PointField> points{{"height", 2, heights}};
    const std::vector<CellField> cells{{"heat", 1, heats}};
    const auto file = io::parse_mixed_vtu<Dim::value>(io::format_vtu(mesh, points, cells), "m.vtu");
    CHECK(file.warnings.empty());
    CHECK(file.mesh == mesh);
    CHECK(file.point_fields == points);
    CHECK(file.cell_fields == cells);
  }
}

TEST_CASE("vtu_files_of_simplices_are_read_as_mixed_cells_and_the_other_way_round") {
  const TetMesh mesh = box_with_everything();
  CHECK(parse(io::format_vtu(mesh)).mesh == mesh::mixed_mesh_of(mesh));
  CHECK(io::parse_tet_vtu(io::format_vtu(mesh::mixed_mesh_of(mesh)), "m.vtu").mesh == mesh);
  CHECK(io::format_vtu(mesh::mixed_mesh_of(mesh)) == io::format_vtu(mesh));
}

TEST_CASE("vtu_cells_of_other_programs_are_taken_and_their_faces_marked") {
  const MixedMeshFile<3> file = parse(house);
  CHECK(file.mesh.kinds.flat() == std::vector{CellKind::hexahedron, CellKind::pyramid});
  CHECK(file.mesh.boundary.size() == 9);
  CHECK(file.mesh.boundary[0] ==
        MarkedMixedFacet<3>{{VertexId{0}, VertexId{3}, VertexId{2}, VertexId{1}}, 7});
  CHECK(file.mesh.boundary[1] == MarkedMixedFacet<3>{{VertexId{4}, VertexId{5}, VertexId{8}}, 8});
  for (std::size_t i = 2; i < 9; ++i) CHECK(file.mesh.boundary[i].marker == 1);
  CHECK(file.cell_fields[0] == CellField{"heat", 1, {10, 11}});
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("7 of 9 boundary faces have no marker") == 0);
  CHECK(file.mesh.marker_names == std::map<Marker, std::string>{{1, "unmarked"}});
}

TEST_CASE("vtu_prisms_are_written_with_the_base_outwards_and_taken_either_way") {
  const MixedMesh<3> mesh = mixed_shelf::single(CellKind::prism);
  MixedMesh<3> turned = mesh;
  const auto row = turned.corners[0];
  std::swap(row[1], row[2]), std::swap(row[4], row[5]);
  const std::string bytes = io::format_vtu(mesh);
  const io::VtkGrid grid = io::parse_vtu_grid(bytes, "m.vtu");
  CHECK(std::vector(grid.connectivity.begin(), grid.connectivity.begin() + 6) ==
        std::vector<std::int64_t>{0, 2, 1, 3, 5, 4});
  CHECK(grid.types[0] == 13);  // then its two triangles and three quadrilaterals
  CHECK(std::ranges::count(grid.types, 5) == 2);
  CHECK(std::ranges::count(grid.types, 9) == 3);
  for (const auto& written : {mesh, turned}) {
    const MixedMeshFile<3> file = parse(io::format_vtu(written));
    CHECK(file.warnings.empty());
    CHECK(file.mesh.corners == mesh.corners);
  }
}

TEST_CASE("vtu_bad_meshes_of_mixed_cells_are_refused") {
  check_refused(
      {{"polyhedron", replaced(house, "12 14 9 5 3", "42 14 9 5 3"), {"m.vtu", "cell 0", "type 42"}},
       {"corners", replaced(house, "8 13 17 20 22", "7 13 17 20 22"), {"cell 0 of type 12 has 7 vert"}},
       {"range", replaced(house, "6 7 8 0 1", "6 7 9 0 1"), {"vertex 9 does not exist"}},
       {"flat", replaced(house, "0.5 0.5 2", "0.5 0.5 1"), {"pyramid 1 (vertices", "volume zero"}},
       {"twice", replaced(house, "0 1 2 3 4 5 6 7 4", "0 1 2 3 4 5 6 6 4"), {"vertex 6 twice"}},
       {"inverted", replaced(house, "0.5 0.5 2", "0.5 0.5 0.5"), {"lie on the same side of face 4-5-6-7"}},
       {"no face", replaced(house, "4 5 8 0 1<", "1 5 8 0 1<"), {"face 1-5-8", "is no face of a cell"}}},
      parse);
  CHECK(refusal([] { (void)io::parse_mixed_vtu<2>(house, "m.vtu"); }).find("z = const") != std::string::npos);
}

TEST_CASE("facets_are_written_as_a_surface_with_the_points_that_they_use_alone") {
  const PerId<VertexId, Point3> points(
      std::vector<Point3>{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 5}});
  const auto at = [](std::size_t i) { return VertexId::from(i); };
  const std::vector<MixedFacet<3>> facets{{at(1), at(2), at(3), at(4)}, {at(2), at(5), at(3)}};
  const Folder folder;
  const auto path = folder.path / "surface.vtu";
  io::write_surface_vtu(path, points, facets, {{"cf", 2, {0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}},
                        {{"marker", 1, {3, 4}}});
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const io::VtkGrid grid = io::parse_vtu_grid(bytes, "surface.vtu");
  CHECK(grid.points == std::vector<Point3>(points.begin() + 1, points.end()));
  CHECK(grid.types == std::vector<std::int64_t>{9, 5});
  CHECK(grid.connectivity == std::vector<std::int64_t>{0, 1, 2, 3, 1, 4, 2});
  REQUIRE(grid.point_arrays.size() == 1);
  CHECK(grid.point_arrays[0].name == "cf");
  CHECK(grid.point_arrays[0].values == std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  CHECK_THROWS_WITH_AS(io::write_surface_vtu(path, points, {{at(0), at(1), at(8)}}),
                       doctest::Contains("vertex 8"), InputError);
}
