// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/gmsh.hpp"

#include <bit>
#include <cmath>
#include <cstring>

#include "tests/mesh/io/sample_tet_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

constexpr io::GmshForm old_text{io::GmshVersion::v2_2, false}, old_binary{io::GmshVersion::v2_2, true},
    new_text{io::GmshVersion::v4_1, false}, new_binary{io::GmshVersion::v4_1, true};

TetMeshFile parse(const std::string& bytes) { return io::parse_tet_gmsh(bytes, "m.msh"); }

/// Two tetrahedra over an inner face as Gmsh 2 writes them: tags with gaps, a node of the geometry that no cell uses,
/// points and lines.
const std::string old_file =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n3\n2 7 \"the wall\"\n2 8 \"membrane\"\n3 5 \"steel\"\n$EndPhysicalNames\n"
    "$Nodes\n6\n"
    "10 0 0 0\n"
    "20 1 0 0\n"
    "30 0 1 0\n"
    "99 5 5 5\n"
    "40 0 0 1\n"
    "15 1 1 1\n"
    "$EndNodes\n"
    "$Elements\n6\n"
    "1 15 2 0 1 10\n"
    "2 1 2 0 1 10 20\n"
    "3 2 2 7 3 10 30 20\n"
    "4 2 2 8 4 20 30 40\n"
    "5 4 2 5 1 10 20 30 40\n"
    "6 4 2 6 2 20 30 40 15\n"
    "$EndElements\n";

/// The same as Gmsh 4 writes it, with parametric nodes and an entity in two groups.
const std::string new_file =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n3\n2 7 \"the wall\"\n2 8 \"membrane\"\n3 5 \"steel\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 2 2\n"
    "1 0 0 0 0\n"
    "1 0 0 0 1 0 0 0 2 1 -1\n"
    "3 0 0 0 1 1 0 1 7 1 1\n"
    "4 0 0 0 1 1 1 2 -8 7 0\n"
    "1 0 0 0 1 1 1 1 5 2 3 -4\n"
    "2 0 0 0 1 1 1 1 6 0\n"
    "$EndEntities\n"
    "$Nodes\n3 6 10 99\n"
    "1 1 1 2\n10\n20\n0 0 0 0\n1 0 0 1\n"
    "2 3 1 1\n30\n0 1 0 0.5 0.5\n"
    "3 1 0 3\n99\n40\n15\n5 5 5\n0 0 1\n1 1 1\n"
    "$EndNodes\n"
    "$Elements\n6 6 1 6\n"
    "0 1 15 1\n1 10\n"
    "1 1 1 1\n2 10 20\n"
    "2 3 2 1\n3 10 30 20\n"
    "2 4 2 1\n4 20 30 40\n"
    "3 1 4 1\n5 10 20 30 40\n"
    "3 2 4 1\n6 20 30 40 15\n"
    "$EndElements\n";

/// A binary file of this machine as one of the other byte order would write it: all its numbers turned round.
std::string other_byte_order() {
  std::string bytes = "$MeshFormat\n2.2 1 8\n";
  const auto append = [&](auto number) {
    auto raw = std::bit_cast<std::array<char, sizeof number>>(number);
    std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
  };
  append(std::int32_t{1});
  bytes += "\n$EndMeshFormat\n$Nodes\n4\n";
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    append(static_cast<std::int32_t>(i + 1));
    for (const double x : {points[i].x, points[i].y, points[i].z}) append(x);
  }
  bytes += "\n$EndNodes\n$Elements\n1\n";
  for (const std::int32_t entry : {4, 1, 2, 1, 9, 9, 1, 2, 3, 4}) append(entry);
  return bytes + "\n$EndElements\n";
}

}  // namespace

TEST_CASE("gmsh_round_trip_keeps_all_but_vertex_markers_in_both_versions_as_text_and_binary") {
  TetMesh mesh = box_with_everything();
  mesh.vertex_markers = PerId<VertexId, Marker>(mesh.vertex_count(), 0);
  for (const io::GmshForm& form : {old_text, old_binary, new_text, new_binary}) {
    CAPTURE(form.binary);
    const std::string bytes = io::format_gmsh(mesh, form);
    const TetMeshFile back = parse(bytes);
    CHECK(back.warnings.empty());
    CHECK(back.mesh == mesh);
    CHECK(io::format_gmsh(back.mesh, form) == bytes);
  }
}

TEST_CASE("gmsh_mesh_whose_markers_are_all_0_keeps_them") {
  TetMesh mesh = two_tets();
  for (MarkedFace& face : mesh.boundary) face.marker = 0;
  mesh.marker_names.clear();
  for (const io::GmshForm& form : {old_text, new_binary})
    CHECK(parse(io::format_gmsh(mesh, form)).mesh == mesh);
}

TEST_CASE("gmsh_files_of_both_versions_give_the_same_mesh") {
  for (const std::string& text : {old_file, new_file}) {
    const TetMeshFile file = parse(text);
    CHECK(file.mesh.points.flat() ==
          std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
    CHECK(file.mesh.regions.flat() == std::vector<double>{5, 6});
    CHECK(file.mesh.marker_names ==
          std::map<Marker, std::string>{{1, "unmarked"}, {7, "the wall"}, {8, "membrane"}});
    CHECK(file.mesh.region_names.at(5) == "steel");
    CHECK(file.mesh.interfaces == std::vector<MarkedFace>{{{VertexId{1}, VertexId{2}, VertexId{3}}, 8}});
    CHECK(file.mesh.boundary[0] == MarkedFace{{VertexId{0}, VertexId{2}, VertexId{1}}, 7});
    CHECK(file.mesh.boundary[1].marker == 1);
    std::string told;
    for (const std::string& warning : file.warnings) told += warning + "\n";
    for (const char* part : {"1 vertex that no cell uses", "5 of 6 boundary faces"})
      CHECK_MESSAGE(told.find(part) != std::string::npos, part, " in ", told);
    CHECK((told.find("in several physical groups") != std::string::npos) == (text == new_file));
  }
}

TEST_CASE("gmsh_file_without_physical_groups_takes_the_numbers_of_the_geometry") {
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n2\n1 2 2 0 31 1 3 2\n2 4 2 0 32 1 2 3 4\n$EndElements\n"
      "$ElementNodeData\n1\n\"t\"\n$EndElementNodeData\n";
  const TetMeshFile file = parse(text);
  CHECK(file.mesh.boundary[0].marker == 31);
  CHECK(file.mesh.regions.flat() == std::vector<double>{32});
  REQUIRE(file.warnings.size() == 4);
  CHECK(file.warnings[0].find("$ElementNodeData was passed over") != std::string::npos);
  CHECK(file.warnings[1].find("1 elements of dimension 2 are in no physical group") == 0);
  CHECK(file.warnings[2].find("1 elements of dimension 3 are in no physical group") == 0);
}

TEST_CASE("gmsh_fields_of_vertices_and_cells_come_back_to_the_last_bit") {
  std::uint64_t bits = 1;
  const auto fill = [&](std::size_t count) {
    std::vector<double> values{INFINITY};
    while (values.size() < count) {
      bits = bits * 6364136223846793005U + 1442695040888963407U;
      if (const auto value = std::bit_cast<double>(bits); std::isfinite(value)) values.push_back(value);
    }
    return values;
  };
  const auto check = [&](const auto& mesh, const auto& parse_it, std::size_t cell_count) {
    std::vector<PointField> points;
    std::vector<CellField> cells;
    for (const std::size_t components : {1, 3, 9}) {
      const std::string name = "of " + std::to_string(components) + " <&>";
      points.push_back({name, components, fill(components * mesh.vertex_count())});
      cells.push_back({name, components, fill(components * cell_count)});
    }
    for (const io::GmshForm& form : {old_text, old_binary, new_text, new_binary}) {
      const auto back = parse_it(io::format_gmsh(mesh, form, points, cells));
      CHECK(back.warnings.empty());
      CHECK(back.point_fields == points);
      CHECK(back.cell_fields == cells);
    }
  };
  const TetMesh box = box_with_everything();
  check(box, parse, box.tet_count());
  TriangleMesh grid = grid_with_everything();
  for (double& region : grid.regions) region = region > 0 ? 4 : 0;
  check(
      grid, [](const std::string& bytes) { return io::parse_gmsh(bytes, "m.msh"); }, grid.triangle_count());
}

TEST_CASE("gmsh_two_components_become_three_and_other_numbers_are_refused") {
  const TetMesh mesh = two_tets();
  const TetMeshFile back = parse(io::format_gmsh(mesh, {}, {}, {{"v", 2, {1, 2, 3, 4}}}));
  REQUIRE(back.cell_fields.size() == 1);
  CHECK(back.cell_fields[0] == CellField{"v", 3, {1, 2, 0, 3, 4, 0}});
  const auto write = [&](const CellField& field) {
    return refusal([&] { (void)io::format_gmsh(mesh, {}, {}, {field}); });
  };
  CHECK(write({"v", 4, std::vector<double>(8)}).find("4 components") != std::string::npos);
  CHECK(write({"a \"v\"", 1, std::vector<double>(2)}).find("quotation mark") != std::string::npos);
  CHECK(write({"v", 1, std::vector<double>(3)}).find("do not fit 2 cells") != std::string::npos);
}

TEST_CASE("gmsh_data_follow_the_tags_and_those_that_do_not_cover_the_mesh_are_left_out") {
  const std::string head = "\n1\n0.5\n4\n0\n1\n";  // after the name: a time; a step, components
  const TetMeshFile file =
      parse(old_file + "$NodeData\n2\n\"t\"\n\"scheme\"" + head +
            "6\n0\n15 5\n40 4\n30 3\n20 2\n10 1\n99 nan\n" + "$EndNodeData\n$ElementData\n1\n\"e\"" + head +
            "3\n0\n4 -4\n6 6\n5 5\n$EndElementData\n" + "$ElementData\n1\n\"half\"" + head +
            "1\n0\n5 5\n$EndElementData\n" + "$NodeData\n1\n\"t\"" + head + "1\n0\n10 1\n$EndNodeData\n");
  REQUIRE(file.point_fields.size() == 1);
  CHECK(file.point_fields[0] == PointField{"t", 1, {1, 2, 3, 4, 5}});
  REQUIRE(file.cell_fields.size() == 1);
  CHECK(file.cell_fields[0] == CellField{"e", 1, {5, 6}});
  std::string told;
  for (const std::string& warning : file.warnings) told += warning + "\n";
  CHECK(told.find("elements \"half\" were left out: not every cell has one") != std::string::npos);
  CHECK(told.find("nodes \"t\" were left out: others have this name") != std::string::npos);
}

TEST_CASE("gmsh_binary_file_of_the_other_byte_order_is_read") {
  const TetMesh mesh = parse(other_byte_order()).mesh;
  CHECK(mesh.points[VertexId{3}] == Point3{0, 0, 1});
  CHECK(mesh.regions.flat() == std::vector<double>{9});
}

TEST_CASE("gmsh_bad_text_is_refused_with_its_line") {
  check_refused(
      {{"empty", " ", {"m.msh", "$MeshFormat"}},
       {"version", replaced(old_file, "2.2 0 8", "3 0 8"), {"m.msh:2", "2.2, 4 and 4.1"}},
       {"size", replaced(old_file, "2.2 0 8", "2.2 0 4"), {"m.msh:2", "makes no sense"}},
       {"NaN", replaced(old_file, "30 0 1 0", "30 0 nan 0"), {"m.msh:14", "nan", "y coordinate"}},
       {"columns", replaced(old_file, "30 0 1 0", "30 0 1"), {"m.msh:1"}},
       {"node twice", replaced(old_file, "99 5 5 5", "10 5 5 5"), {"m.msh", "node 10 comes twice"}},
       {"node missing", replaced(old_file, "10 20 30 40", "10 20 30 41"), {"m.msh:25", "node 41"}},
       {"type", replaced(old_file, "5 4 2 5 1 10", "5 77 2 5 1 10"), {"m.msh:25", "type 77"}},
       {"quadrilaterals",
        replaced(old_file, "3 2 2 7 3 10 30 20", "3 3 2 7 3 10 30 20 40"),
        {"m.msh", "has 4 corners"}},
       {"flat", replaced(old_file, "10 20 30 40", "10 20 30 30"), {"m.msh:25", "vertex 2 twice"}},
       {"count of nodes", replaced(old_file, "$Nodes\n6", "$Nodes\n7"), {"m.msh:18", "$EndNodes"}},
       {"too many nodes", replaced(old_file, "$Nodes\n6", "$Nodes\n5"), {"m.msh:17", "$EndNodes"}},
       {"huge count", replaced(old_file, "$Nodes\n6", "$Nodes\n6000000000000"), {"m.msh:11", "cannot hold"}},
       {"negative count", replaced(old_file, "$Nodes\n6", "$Nodes\n-6"), {"m.msh:11", "-6"}},
       {"name", replaced(old_file, "\"membrane\"", "membrane"), {"m.msh:7", "quotation marks"}},
       {"name twice", replaced(old_file, "2 8 \"", "2 7 \""), {"m.msh:7", "second name"}},
       {"no elements", old_file.substr(0, old_file.find("$Elements")), {"m.msh", "$Elements", "cut short"}},
       {"cut short", old_file.substr(0, old_file.find("6 4 2 6 2")), {"m.msh:25", "file ends"}},
       {"no end",
        old_file.substr(0, old_file.find("$EndElements")),
        {"m.msh", "ends inside the section $Elements"}},
       {"twice", old_file + "$Nodes\n0\n$EndNodes\n", {"m.msh", "second time"}},
       {"data cut short", old_file + "$NodeData\n1\n\"t\"\n", {"m.msh:30", "real tags", "cut short"}},
       {"data of no components",
        old_file + "$NodeData\n1\n\"t\"\n1\n0\n3\n0\n0\n1\n10 1\n$EndNodeData\n",
        {"components from 1"}},
       {"data of a node that is not there",
        old_file + "$NodeData\n1\n\"t\"\n1\n0\n3\n0\n1\n1\n11 1\n$EndNodeData\n",
        {"node 11"}},
       {"more rows of data than said",
        old_file + "$NodeData\n1\n\"t\"\n1\n0\n3\n0\n1\n1\n10 1\n20 1\n$EndNodeData\n",
        {"$EndNodeData"}},
       {"no section", old_file + "hello\n", {"m.msh:28", "hello"}},
       {"blocks", replaced(new_file, "$Nodes\n3 6", "$Nodes\n3 5"), {"m.msh", "more nodes than"}},
       {"fewer", replaced(new_file, "$Nodes\n3 6", "$Nodes\n3 7"), {"m.msh", "7 nodes", "6"}},
       {"elements", replaced(new_file, "$Elements\n6 6", "$Elements\n6 7"), {"m.msh", "7 elements", "6"}},
       {"parametric", replaced(new_file, "2 3 1 1\n30", "2 3 2 1\n30"), {"m.msh", "parametric 2"}}},
      parse);
}

TEST_CASE("every_prefix_of_a_binary_gmsh_file_is_refused") {
  for (const io::GmshForm& form : {old_binary, new_binary}) {
    const std::string bytes = io::format_gmsh(two_tets(), form);
    for (std::size_t length = 0; length + 1 < bytes.size(); ++length)
      CHECK_MESSAGE(refusal([&] { parse(bytes.substr(0, length)); }) != "accepted", "cut after byte ",
                    length);
    CHECK(refusal([&] { parse(bytes.substr(0, bytes.size() / 2)); }).find("m.msh, byte ") == 0);
  }
}

TEST_CASE("gmsh_writer_refuses_what_the_format_cannot_carry") {
  TetMesh mesh = two_tets();
  mesh.boundary[0].marker = -1;
  CHECK(refusal([&] { (void)io::format_gmsh(mesh); }).find("marker -1") == 0);
  mesh = two_tets();
  mesh.marker_names[1] = "a \"wall\"";
  CHECK(refusal([&] { (void)io::format_gmsh(mesh); }).find("marker 1") == 0);
  mesh = two_tets();
  mesh.regions[TetId{0}] = -1;
  CHECK(refusal([&] { (void)io::format_gmsh(mesh); }).find("cell 0") == 0);
}

TEST_CASE("gmsh_carries_triangle_meshes_too") {
  TriangleMesh mesh = grid_with_everything();
  mesh.vertex_markers = PerId<VertexId, Marker>(mesh.vertex_count(), 0);
  for (double& region : mesh.regions) region = region > 0 ? 4 : 0;
  for (const io::GmshForm& form : {old_text, old_binary, new_text, new_binary}) {
    const MeshFile back = io::parse_gmsh(io::format_gmsh(mesh, form), "m.msh");
    CHECK(back.warnings.empty());
    check_same_mesh(mesh, back.mesh);
  }
  CHECK(refusal([&] { (void)io::parse_gmsh(old_file, "m.msh"); }).find("cells of space") !=
        std::string::npos);
  CHECK(refusal([&] { parse(io::format_gmsh(mesh)); }).find("no cells of space") != std::string::npos);
}
