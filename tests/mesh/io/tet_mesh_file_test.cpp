// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/tet_mesh_file.hpp"

#include <filesystem>
#include <fstream>

#include "leonhard/mesh/io/file_dimension.hpp"
#include "leonhard/mesh/io/mesh_file.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"
#include "tests/mesh/io/folder.hpp"
#include "tests/mesh/io/sample_tet_meshes.hpp"

using namespace leonhard;
using namespace leonhard::test;

namespace {

io::MeshSoup<3> soup_of(const TetMesh& mesh) {
  io::MeshSoup<3> soup;
  soup.source = "soup";
  soup.mesh.points = mesh.points;
  for (const auto& corners : mesh.corners) soup.add_cell(CellKind::tetrahedron, corners, 0);
  for (const MarkedFace& face : mesh.boundary) soup.add_facet(face.corners, face.marker, 0);
  return soup;
}

MixedFacet<3> face_of(IdRaw a, IdRaw b, IdRaw c) { return {VertexId{a}, VertexId{b}, VertexId{c}}; }

std::array<VertexId, 3> sorted_face(const MixedFacet<3>& face) {
  return mesh::sorted_facet(std::array{face[0], face[1], face[2]}).corners;
}

}  // namespace

TEST_CASE("every_format_gives_every_mesh_of_the_shelf_back") {
  const Folder folder;
  for (const tet_shelf::Entry& entry : tet_shelf::all()) {
    if (entry.mesh.tet_count() > 600) continue;  // one hollow ball is like another
    CAPTURE(entry.name);
    for (const char* name : {"m.su2", "m.vtu", "m.msh", "m.mesh", "m.node"}) {
      CAPTURE(name);
      io::write_tet_mesh(folder.path / name, entry.mesh);
      const TetMeshFile file = io::read_tet_mesh(folder.path / name);
      CHECK(file.warnings.empty());
      CHECK(file.mesh == entry.mesh);
      CHECK(io::file_dimension(folder.path / name) == 3);
    }
  }
}

TEST_CASE("formats_carry_what_their_headers_say") {
  const Folder folder;
  const TetMesh mesh = box_with_everything();
  for (const char* name : {"m.vtu", "m.mesh", "m.ele"}) {
    CAPTURE(name);
    io::write_tet_mesh(folder.path / name, mesh);
    CHECK(io::read_tet_mesh(folder.path / name).mesh == mesh);
  }
  io::write_tet_mesh(folder.path / "m.msh", mesh);
  TetMesh without_vertex_markers = mesh;
  std::fill(without_vertex_markers.vertex_markers.begin(), without_vertex_markers.vertex_markers.end(), 0);
  CHECK(io::read_tet_mesh(folder.path / "m.msh").mesh == without_vertex_markers);

  TetMesh plain = mesh;
  plain.marker_names = {{3, "wall"}, {7, "farfield"}};
  io::write_tet_mesh(folder.path / "m.su2", plain);
  check_same_geometry_and_boundary(plain, io::read_tet_mesh(folder.path / "m.su2").mesh);
}

TEST_CASE("regions_that_are_no_whole_numbers_are_refused_by_formats_that_know_no_others") {
  const Folder folder;
  TetMesh mesh = two_tets();
  mesh.regions[TetId{1}] = 0.5;
  for (const char* name : {"m.vtu", "m.ele"}) {
    io::write_tet_mesh(folder.path / name, mesh);
    CHECK(io::read_tet_mesh(folder.path / name).mesh == mesh);
  }
  for (const char* name : {"m.msh", "m.mesh"}) {
    CHECK(refusal([&] { io::write_tet_mesh(folder.path / name, mesh); }).find("cell 1: its region is 0.5") ==
          0);
    CHECK_FALSE(std::filesystem::exists(folder.path / name));
  }
}

TEST_CASE("tet_mesh_files_of_unknown_extension_or_missing_are_refused") {
  CHECK(refusal([] { (void)io::read_tet_mesh("wing.mesg"); }).find("did you mean \".mesh\"?") !=
        std::string::npos);
  CHECK(refusal([] { (void)io::read_tet_mesh("no-such-file.mesh"); }).find("does not exist") !=
        std::string::npos);
  CHECK(refusal([] { (void)io::read_tet_mesh("no-such-file.ele"); }).find("no-such-file.node") !=
        std::string::npos);
  CHECK(refusal([] { io::write_tet_mesh("wing.stl", two_tets()); }).find("\".stl\" is no extension") !=
        std::string::npos);
}

TEST_CASE("file_dimension_tells_the_plane_from_space") {
  const Folder folder;
  const TriangleMesh plane = grid_with_hole();
  for (const char* name : {"p.su2", "p.vtu", "p.node"}) io::write_mesh(folder.path / name, plane);
  for (const char* name : {"p.su2", "p.vtu", "p.node", "p.ele", "p.poly", "p.neigh"})
    CHECK_MESSAGE(io::file_dimension(folder.path / name) == 2, name);
  io::write_tet_mesh(folder.path / "s.node", two_tets());
  for (const char* name : {"s.node", "s.ele", "s.face", "s.neigh"})
    CHECK_MESSAGE(io::file_dimension(folder.path / name) == 3, name);
  const auto dimension_of = [&](const char* name, const std::string& text) {
    std::ofstream(folder.path / name) << text;
    return io::file_dimension(folder.path / name);
  };
  CHECK(dimension_of("a.mesh", "# c\nMeshVersionFormatted 1\nDimension\n2\nVertices 0\n") == 2);
  CHECK(dimension_of("a.msh", "MSHID=1\nNDIMS=3\n") == 3);
  CHECK(dimension_of("b.su2", std::string(100000, '%') + "\nNPOIN= 0\nNDIME= 3\n") == 3);
  CHECK(dimension_of("c.ele", "# c\n7 10 0\n") == 3);
  CHECK(dimension_of("d.ele", "7 6\n") == 2);
  CHECK(dimension_of("g.p2dfmt", "1\n2 2\n") == 2);
  CHECK(refusal([&] { dimension_of("e.node", "7 4\n"); }).find("e.node:1: the dimension is 4") !=
        std::string::npos);
  CHECK(refusal([&] { dimension_of("f.su2", "NPOIN= 0\n"); }).find("NDIME") != std::string::npos);
}

TEST_CASE("inverted_tetrahedra_are_turned_over_each_by_itself_with_one_warning") {
  const TetMesh mesh = tet_shelf::box(1, 1, 1);
  io::MeshSoup<3> soup = soup_of(mesh);
  for (const CellId cell : soup.mesh.kinds.ids())
    std::swap(soup.mesh.corners[cell.index()][2], soup.mesh.corners[cell.index()][3]);
  const TetMeshFile file = io::assemble_simplices(soup);
  CHECK(file.mesh.corners == mesh.corners);
  CHECK(file.warnings ==
        std::vector<std::string>{"all 6 tetrahedra are inverted in the file; they were turned over"});

  std::swap(soup.mesh.corners[2][2], soup.mesh.corners[2][3]);
  const TetMeshFile mixed = io::assemble_simplices(soup);
  CHECK(mixed.mesh.corners == mesh.corners);
  CHECK(mixed.warnings ==
        std::vector<std::string>{"5 of 6 tetrahedra are inverted in the file; they were turned over"});
}

TEST_CASE("unlisted_boundary_faces_get_the_marker_of_their_vertices_or_the_first_number_that_is_free") {
  const TetMesh mesh = two_tets();
  io::MeshSoup<3> soup = soup_of(mesh);
  auto& facets = soup.mesh.boundary;
  facets.erase(facets.begin(), facets.begin() + 4);
  for (auto& face : facets) face.marker = 1;
  const auto listed = facets;
  soup.mesh.marker_names = {{2, "two"}};
  soup.mesh.vertex_markers = PerId<VertexId, Marker>(std::vector<Marker>{5, 5, 5, 0, 0});
  const TetMeshFile file = io::assemble_simplices(soup);
  CHECK(file.warnings ==
        std::vector<std::string>{
            "4 of 6 boundary faces have no marker in the file; 1 of them got the one that their "
            "vertices share, the others 3, named unmarked"});
  CHECK_FALSE(mesh::validate(file.mesh));
  for (const MarkedFace& face : file.mesh.boundary) {
    const bool is_listed = std::any_of(listed.begin(), listed.end(), [&](const auto& f) {
      return sorted_face(f.corners) == mesh::sorted_facet(face.corners).corners;
    });
    const bool is_bottom =
        mesh::sorted_facet(face.corners).corners == std::array{VertexId{0}, VertexId{1}, VertexId{2}};
    CHECK(face.marker == (is_listed ? 1 : is_bottom ? 5 : 3));
  }
}

TEST_CASE("listed_inner_faces_are_interfaces_unless_their_marker_is_0") {
  io::MeshSoup<3> soup = soup_of(two_tets());
  soup.add_facet(std::array{VertexId{3}, VertexId{2}, VertexId{1}}, 8, 20);
  const TetMesh mesh = io::assemble_simplices(soup).mesh;
  CHECK(mesh.interfaces == std::vector<MarkedFace>{{{VertexId{3}, VertexId{2}, VertexId{1}}, 8}});
  soup.mesh.boundary.back().marker = 0;
  CHECK(io::assemble_simplices(soup).mesh.interfaces.empty());
  soup.facets_as_they_are = true;
  CHECK(io::assemble_simplices(soup).mesh.interfaces.size() == 1);
}

TEST_CASE("soups_that_are_no_mesh_are_refused_with_ids_and_lines") {
  const io::MeshSoup<3> good = soup_of(tet_shelf::box(1, 1, 1));
  const auto complaint = [&](auto&& spoil) {
    io::MeshSoup<3> soup = good;
    spoil(soup);
    return refusal([&] { (void)io::assemble_simplices(soup); });
  };
  const auto has = [](const std::string& text, const char* part) {
    CHECK_MESSAGE(text.find(part) != std::string::npos, part, " in: ", text);
  };
  has(complaint([](io::MeshSoup<3>& s) { s.mesh.points.clear(); }), "no points");
  has(complaint([](io::MeshSoup<3>& s) { s.mesh.kinds.clear(); }), "no cells of space");
  has(complaint([](io::MeshSoup<3>& s) { s.mesh.points[VertexId{3}].z = std::nan(""); }), "vertex 3 at (");
  has(complaint([](io::MeshSoup<3>& s) {
        s.mesh.corners[1][3] = VertexId{8};
        s.cell_lines[1] = 9;
      }),
      "soup:9: tetrahedron 1 names vertex 8, but the file has only vertices 0 to 7");
  has(complaint([](io::MeshSoup<3>& s) {
        s.mesh.boundary[1].corners = face_of(0, 1, 88);
        s.facet_lines[1] = 30;
      }),
      "soup:30: the marked face 0-1-88 names vertex 88");
  has(complaint([](io::MeshSoup<3>& s) { s.mesh.corners[0][1] = s.mesh.corners[0][0]; }),
      "tetrahedron 0 names vertex 0 twice");
  has(complaint([](io::MeshSoup<3>& s) {
        const auto row = s.mesh.corners[4];
        const std::vector<VertexId> again(row.begin(), row.end());
        s.add_cell(CellKind::tetrahedron, again, 0);
      }),
      "tetrahedron 6");
  has(complaint([](io::MeshSoup<3>& s) {
        s.mesh.points.push_back({0.5, 0.25, -1});
        s.mesh.points.push_back({0.5, 0.25, -2});
        const auto face = s.mesh.boundary.front().corners;
        for (const IdRaw apex : {8, 9})
          s.add_cell(CellKind::tetrahedron, std::array{face[0], face[2], face[1], VertexId{apex}}, 0);
      }),
      "tetrahedr");
  has(complaint([](io::MeshSoup<3>& s) {
        s.mesh.points.push_back({9, 9, 9});
        s.add_facet(std::array{VertexId{0}, VertexId{1}, VertexId{8}}, 4, 7);
      }),
      "soup:7: the marked face 0-1-8 has vertex 8, which no cell uses");
  has(complaint([](io::MeshSoup<3>& s) {
        s.facet_lines.front() = 5;
        const auto face = s.mesh.boundary.front().corners;
        s.add_facet(std::span(face.begin(), face.end()), 2, 6);
      }),
      "comes a second time, after line 5 (markers 1 and 2)");
}

TEST_CASE("a_face_listed_twice_with_one_marker_counts_once") {
  io::MeshSoup<3> soup = soup_of(two_tets());
  const auto face = soup.mesh.boundary.front();
  soup.add_facet(std::span(face.corners.begin(), face.corners.end()), face.marker, 0);
  const TetMeshFile file = io::assemble_simplices(soup);
  CHECK(file.mesh.boundary.size() == 6);
  CHECK(file.warnings ==
        std::vector<std::string>{"1 marked faces are listed more than once; each was taken once"});
}

TEST_CASE("tetrahedra_that_overlap_are_refused_though_each_is_positive") {
  io::MeshSoup<3> soup = soup_of(two_tets());
  const io::MeshSoup<3> again = soup_of(two_tets());  // the same, a little aside
  for (const Point3 p : again.mesh.points) soup.mesh.points.push_back({p.x + 0.25, p.y, p.z});
  const auto moved = [](auto corners) {
    std::vector<VertexId> result(corners.begin(), corners.end());
    for (VertexId& v : result) v.raw += 5;
    return result;
  };
  for (const CellId cell : again.mesh.kinds.ids())
    soup.add_cell(CellKind::tetrahedron, moved(again.mesh.corners_of(cell)), 0);
  for (const auto& face : again.mesh.boundary) soup.add_facet(moved(face.corners), face.marker, 0);
  CHECK(refusal([&] { (void)io::assemble_simplices(soup); }).find("soup: the mesh is tangled: ") == 0);
}
