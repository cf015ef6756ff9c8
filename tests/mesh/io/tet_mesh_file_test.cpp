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
  soup.points = mesh.points;
  for (const auto& corners : mesh.corners) soup.cells.push_back({corners, 4});
  for (const MarkedFace& face : mesh.boundary) soup.facets.push_back({face.corners, face.marker});
  return soup;
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

TEST_CASE("inverted_tetrahedra_are_turned_over_with_a_warning_only_if_all_are") {
  const TetMesh mesh = tet_shelf::box(1, 1, 1);
  io::MeshSoup<3> soup = soup_of(mesh);
  for (io::SoupCell& cell : soup.cells) std::swap(cell.corners[2], cell.corners[3]);
  const TetMeshFile file = io::assemble(soup, io::FacetRule::facets_are_the_boundary);
  CHECK(file.mesh.corners == mesh.corners);
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("all 6 tetrahedra are inverted") == 0);

  std::swap(soup.cells[2].corners[0], soup.cells[2].corners[1]);
  soup.cells[2].line = 12;
  const std::string message =
      refusal([&] { (void)io::assemble(soup, io::FacetRule::facets_are_the_boundary); });
  CHECK(message.find(
            "soup:12: 1 of 6 tetrahedra are of positive volume unlike the others: tetrahedron 2 (vertices") ==
        0);
}

TEST_CASE("unlisted_boundary_faces_get_the_marker_of_their_vertices_or_the_first_number_that_is_free") {
  const TetMesh mesh = two_tets();
  io::MeshSoup<3> soup = soup_of(mesh);
  soup.facets.erase(soup.facets.begin(), soup.facets.begin() + 4);
  for (io::SoupFacet<3>& face : soup.facets) face.marker = 1;
  soup.marker_names = {{2, "two"}};
  soup.vertex_markers = {5, 5, 5, 0, 0};
  const TetMeshFile file = io::assemble(soup, io::FacetRule::fill_in_the_boundary);
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0] ==
        "4 of 6 boundary faces have no marker in the file; they got the marker their three vertices share, "
        "or 3");
  CHECK_FALSE(mesh::validate(file.mesh));
  for (const MarkedFace& face : file.mesh.boundary) {
    const bool is_listed =
        std::any_of(soup.facets.begin(), soup.facets.end(), [&](const io::SoupFacet<3>& f) {
          return mesh::sorted_facet(f.corners).corners == mesh::sorted_facet(face.corners).corners;
        });
    const bool is_bottom =
        mesh::sorted_facet(face.corners).corners == std::array{VertexId{0}, VertexId{1}, VertexId{2}};
    CHECK(face.marker == (is_listed ? 1 : is_bottom ? 5 : 3));
  }
}

TEST_CASE("listed_inner_faces_are_interfaces_unless_their_marker_is_0") {
  io::MeshSoup<3> soup = soup_of(two_tets());
  soup.facets.push_back({{VertexId{3}, VertexId{2}, VertexId{1}}, 8, 20});
  const TetMesh mesh = io::assemble(soup, io::FacetRule::fill_in_the_boundary).mesh;
  CHECK(mesh.interfaces == std::vector<MarkedFace>{{{VertexId{3}, VertexId{2}, VertexId{1}}, 8}});
  CHECK(refusal([&] { (void)io::assemble(soup, io::FacetRule::facets_are_the_boundary); }).find("3-2-1") !=
        std::string::npos);
  soup.facets.back().marker = 0;
  CHECK(io::assemble(soup, io::FacetRule::fill_in_the_boundary).mesh.interfaces.empty());
}

TEST_CASE("soups_that_are_no_mesh_are_refused_with_ids_and_lines") {
  const io::MeshSoup<3> good = soup_of(tet_shelf::box(1, 1, 1));
  const auto complaint = [&](auto&& spoil) {
    io::MeshSoup<3> soup = good;
    spoil(soup);
    return refusal([&] { (void)io::assemble(soup, io::FacetRule::facets_are_the_boundary); });
  };
  const auto has = [](const std::string& text, const char* part) {
    CHECK_MESSAGE(text.find(part) != std::string::npos, part, " in: ", text);
  };
  has(complaint([](io::MeshSoup<3>& s) { s.points.clear(); }), "no points");
  has(complaint([](io::MeshSoup<3>& s) { s.cells.clear(); }), "no tetrahedra");
  has(complaint([](io::MeshSoup<3>& s) { s.points[VertexId{3}].z = std::nan(""); }), "vertex 3 is at (");
  has(complaint([](io::MeshSoup<3>& s) {
        s.cells[1] = {{VertexId{0}, VertexId{1}, VertexId{2}, VertexId{8}}, 4, 9};
      }),
      "soup:9: tetrahedron 1 names vertex 8, but the file has only vertices 0 to 7");
  has(complaint([](io::MeshSoup<3>& s) {
        s.facets[1] = {{VertexId{0}, VertexId{1}, VertexId{88}}, 1, 30};
      }),
      "soup:30: the marked face 0-1-88 names vertex 88");
  has(complaint([](io::MeshSoup<3>& s) { s.cells[0].corners[1] = s.cells[0].corners[0]; }),
      "tetrahedron 0 (vertices");
  has(complaint([](io::MeshSoup<3>& s) { s.cells[0].corners[1] = s.cells[0].corners[0]; }), "has no volume");
  has(complaint([](io::MeshSoup<3>& s) { s.cells.push_back(s.cells[4]); }), "tetrahedron 6");
  has(complaint([](io::MeshSoup<3>& s) { s.cells.pop_back(); }), "is no boundary face");
  has(complaint([](io::MeshSoup<3>& s) {
        s.points.push_back({0.5, 0.25, -1});
        s.points.push_back({0.5, 0.25, -2});
        const auto& face = s.facets.front().corners;
        s.cells.push_back({{face[0], face[2], face[1], VertexId{8}}, 4, 0});
        s.cells.push_back({{face[0], face[2], face[1], VertexId{9}}, 4, 0});
      }),
      "tetrahedr");
  has(complaint([](io::MeshSoup<3>& s) { s.points.push_back({9, 9, 9}); }), "vertex 8 at (9, 9, 9)");
  has(complaint([](io::MeshSoup<3>& s) {
        s.facets.front().line = 5;
        s.facets.push_back(s.facets.front());
        s.facets.back().line = 6;
        s.facets.back().marker = 2;
      }),
      "comes a second time, after line 5 (markers 1 and 2)");
  has(complaint([](io::MeshSoup<3>& s) { s.facets.pop_back(); }), "has no marker");
}

TEST_CASE("tetrahedra_that_overlap_are_refused_though_each_is_positive") {
  io::MeshSoup<3> soup = soup_of(two_tets());
  const io::MeshSoup<3> again = soup_of(two_tets());  // the same, a little aside
  for (Point3 p : again.points) soup.points.push_back({p.x + 0.25, p.y, p.z});
  const auto moved = [](auto corners) {
    for (VertexId& v : corners) v.raw += 5;
    return corners;
  };
  for (const io::SoupCell& cell : again.cells) soup.cells.push_back({moved(cell.corners), 4});
  for (const io::SoupFacet<3>& face : again.facets) soup.facets.push_back({moved(face.corners), face.marker});
  CHECK(refusal([&] {
          (void)io::assemble(soup, io::FacetRule::facets_are_the_boundary);
        }).find("soup: the mesh is tangled: ") == 0);
}
