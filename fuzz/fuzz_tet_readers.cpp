// SPDX-License-Identifier: MIT
// Every reader of tetrahedral meshes, of surfaces and of points of space either returns or throws InputError; a mesh that
// it returns passes the validators and survives its own writer; a surface's corners exist and its points are finite. The
// input is a text of its own, or a list of edits to a valid text.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "fuzz/fuzz_text.hpp"
#include "leonhard/mesh/io/formats/gmsh.hpp"
#include "leonhard/mesh/io/formats/medit.hpp"
#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/formats/tetgen_files.hpp"
#include "leonhard/mesh/io/points3_file.hpp"
#include "leonhard/mesh/io/vtu.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/validate.hpp"

namespace {

using namespace leonhard;
using fuzzing::report;

// ---- valid texts ----

/// Two tetrahedra over an inner face, with everything that a mesh may carry.
TetMesh sample_mesh(bool with_vertex_markers) {
  PerId<VertexId, Point3> points(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  const auto tet = [](IdRaw a, IdRaw b, IdRaw c, IdRaw d) {
    return std::array{VertexId{a}, VertexId{b}, VertexId{c}, VertexId{d}};
  };
  PerId<TetId, std::array<VertexId, 4>> corners(std::vector{tet(0, 1, 2, 3), tet(1, 2, 3, 4)});
  mesh::MarkedFacetRules rules;
  rules.unlisted_boundary = 2;
  rules.take_inner_facets = true;
  std::vector<MarkedFace> faces{{{VertexId{0}, VertexId{1}, VertexId{2}}, 5},
                                {{VertexId{1}, VertexId{2}, VertexId{3}}, 9}};
  TetMesh mesh = mesh::make_tet_mesh(points, corners, faces, {{2, "outer"}, {5, "bottom"}}, "sample", rules);
  mesh.regions[TetId{1}] = 4;
  if (with_vertex_markers) mesh.vertex_markers[VertexId{3}] = -1;
  return mesh;
}

constexpr const char* ascii_vtu =
    "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1"
    "</DataArray></Points>"
    "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 1 2 3</DataArray>"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 7</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 10</DataArray></Cells>"
    "<CellData><DataArray type=\"Int32\" Name=\"medit:ref\" format=\"ascii\">4 0</DataArray></CellData>"
    "</Piece></UnstructuredGrid></VTKFile>";

constexpr const char* gmsh_with_gaps =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"wall\"\n3 5 "
    "\"steel\"\n$EndPhysicalNames\n"
    "$Entities\n1 0 1 1\n1 0 0 0 0\n3 0 0 0 1 1 0 1 -7 1 1\n1 0 0 0 1 1 1 2 5 6 1 3\n$EndEntities\n"
    "$Nodes\n2 5 10 99\n2 3 1 3\n10\n20\n30\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 1 0 2\n99\n40\n5 5 5\n0 0 1\n"
    "$EndNodes\n$Elements\n3 3 1 3\n0 1 15 1\n1 10\n2 3 2 1\n2 10 30 20\n3 1 4 1\n3 10 20 30 "
    "40\n$EndElements\n"
    "$NodeData\n1\n\"t\"\n1\n0\n3\n0\n1\n4\n10 0.5\n20 1\n30 2\n40 -1\n$EndNodeData\n";

constexpr const char* plane_gmsh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 2\n2 1 0 2\n3 1 1 2\n4 0 1 2\n9 2 0 "
    "2\n$EndNodes\n"
    "$Elements\n4\n1 1 2 6 1 1 2\n2 1 2 -7 2 3 4\n3 3 2 8 1 1 2 3 4\n4 2 2 9 2 2 9 3\n$EndElements\n";

constexpr const char* medit =
    "# marker 7 wall\nMeshVersionFormatted 1\nDimension\n3\nVertices\n4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 2\n"
    "Triangles 1\n1 3 2 7\nEdges 1\n1 2 5\nNormals\n1\n0 0 1\nTetrahedra\n1\n1 2 3 4 6\nEnd\n";

constexpr const char* off =
    "OFF\n4 3 6\n0 0 0\n1 0 0\n0 1 0 255 0 0\n0 0 1\n3 0 2 1\n4 0 1 3 2 0.5\n3 1 2 3\n";
constexpr const char* obj =
    "v 0 0 0\nv 1 0 0 1\nvn 0 0 1\nv 0 1 0\nv 0 0 1\nf 1/1 3//2 2\nf -4 -3 -1\nl 1 2\n";
constexpr const char* jigsaw =
    "# "
    "c\nMSHID=3;EUCLIDEAN-MESH\nNDIMS=3\nPOINT=3\n0;0;0;0\n1;0;0;0\n0;1;0;0\nEDGE2=1\n0;1;0\nTRIA3=1\n0;2;1;"
    "7\n";
constexpr const char* poly =
    "4 3 0 1\n1 0 0 0 1\n2 1 0 0 1\n3 0 1 0 1\n4 0 0 1 1\n2 1\n2 1 7\n3 1 3\n 2\n2 1 4\n1 0.1 0.2 0\n1\n3 1 "
    "2 4\n0\n0\n";
constexpr const char* smesh = "3 3 1 0\n0 0 0 0 5\n1 1 0 0 5\n2 0 1 0 5\n1 1\n3 0 1 2 7\n0\n";
constexpr const char* ascii_stl =
    "solid a\nfacet normal nan 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid a\nSOLID b\nendsolid\n";

template <class Number>
void append_bytes(std::string& bytes, Number number, bool big_endian = false) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (big_endian) std::reverse(raw.begin(), raw.end());  // the fuzzer runs on little-endian machines
  bytes.append(raw.data(), raw.size());
}

std::string binary_stl() {
  std::string bytes(80, ' ');
  append_bytes(bytes, std::uint32_t{1});
  for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) append_bytes(bytes, x);
  append_bytes(bytes, std::uint16_t{0});
  return bytes;
}

std::string ply(const std::string& format) {
  std::string bytes =
      "ply\nformat " + format +
      " 1.0\ncomment c\nelement vertex 3\nproperty uchar red\nproperty float x\nproperty double y\n"
      "property short z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  if (format == "ascii") return bytes + "255 0 0 0\n255 1 0 0\n0 0 1 0\n3 0 1 2\n";
  const bool big = format == "binary_big_endian";
  for (int i = 0; i < 3; ++i) {
    append_bytes(bytes, std::uint8_t{255});
    append_bytes(bytes, i == 1 ? 1.F : 0.F, big);
    append_bytes(bytes, i == 2 ? 1. : 0., big);
    append_bytes(bytes, std::int16_t{0}, big);
  }
  append_bytes(bytes, std::uint8_t{3});
  for (const std::int32_t v : {0, 1, 2}) append_bytes(bytes, v, big);
  return bytes;
}

// ---- properties ----

template <class Element, class Key>
std::vector<Element> sorted(std::vector<Element> elements, const Key& key) {
  std::sort(elements.begin(), elements.end(),
            [&](const Element& a, const Element& b) { return key(a) < key(b); });
  return elements;
}
auto sorted(const std::vector<MarkedFace>& faces) {
  return sorted(faces, [](const MarkedFace& f) { return std::tie(f.corners, f.marker); });
}
auto sorted(const std::vector<MarkedEdge>& edges) {
  return sorted(edges, [](const MarkedEdge& e) { return std::tie(e.from, e.to, e.marker); });
}

/// The mesh is valid, and what its writer makes of it reads as the same mesh, its boundary perhaps in another order.
template <class Mesh>
void check(Mesh mesh, Mesh again, std::string_view text) {
  if (const auto broken = mesh::validate(mesh)) report("a reader returned an invalid mesh: " + *broken, text);
  if (const auto overlap = mesh::validate_embedding(mesh))
    report("a reader returned a tangled mesh: " + *overlap, text);
  mesh.boundary = sorted(mesh.boundary);
  again.boundary = sorted(again.boundary);
  const bool same = mesh.points == again.points && mesh.corners == again.corners &&
                    mesh.boundary == again.boundary && mesh.neighbours == again.neighbours &&
                    mesh.marker_names == again.marker_names && mesh.regions == again.regions &&
                    mesh.vertex_markers == again.vertex_markers;
  if (!same) report("a mesh changed on its way through its own format", text);
}

void try_su2(const std::string& text) {
  const TetMesh mesh = io::parse_tet_su2(text, "fuzz").mesh;
  check(mesh, io::parse_tet_su2(io::format_su2(mesh), "again").mesh, text);
}

void try_vtu(const std::string& text) {
  const TetMesh mesh = io::parse_tet_vtu(text, "fuzz").mesh;
  const TetMesh again = io::parse_tet_vtu(io::format_vtu(mesh), "again").mesh;
  if (again.interfaces != mesh.interfaces) report("interfaces changed on their way through .vtu", text);
  check(mesh, again, text);
}

void try_medit(const std::string& text) {
  const TetMesh mesh = io::parse_medit(text, "fuzz").mesh;
  const TetMesh again = io::parse_medit(io::format_medit(mesh), "again").mesh;
  if (again.interfaces != mesh.interfaces) report("interfaces changed on their way through .mesh", text);
  check(mesh, again, text);
}

void try_gmsh(const std::string& text) {
  const TetMesh mesh = io::parse_tet_gmsh(text, "fuzz").mesh;
  for (const io::GmshVersion version : {io::GmshVersion::v2_2, io::GmshVersion::v4_1})
    for (const bool binary : {false, true}) {
      const TetMesh again = io::parse_tet_gmsh(io::format_gmsh(mesh, {version, binary}), "again").mesh;
      if (again.interfaces != mesh.interfaces) report("interfaces changed on their way through .msh", text);
      check(mesh, again, text);
    }
}

void try_plane_gmsh(const std::string& text) {
  const TriangleMesh mesh = io::parse_gmsh(text, "fuzz").mesh;
  const TriangleMesh again = io::parse_gmsh(io::format_gmsh(mesh), "again").mesh;
  if (again.constraints != mesh.constraints) report("constraints changed on their way through .msh", text);
  check(mesh, again, text);
}

/// One of the files is the fuzzed text, the others are right.
void try_tetgen(const std::string& text, int which) {
  io::TetgenFileTexts texts = io::format_tetgen_files(sample_mesh(true));
  if (which == 0) texts.node = text;
  if (which == 1) texts.ele = text;
  if (which == 2) texts.face = text;
  const TetMesh mesh = io::parse_tetgen_files(texts, "fuzz").mesh;
  check(mesh, io::parse_tetgen_files(io::format_tetgen_files(mesh), "again").mesh, text);
}

void check_points(const PointSet3& set, std::string_view text) {
  if (!std::all_of(set.points.begin(), set.points.end(), [](const Point3& p) { return is_finite(p); }))
    report("a reader returned a point that is not finite", text);
  if (io::parse_node3(io::format_node3(set), "again").set != set)
    report("points changed on their way through .node", text);
  if (io::parse_xyz(io::format_xyz(set), "again").set.points != set.points)
    report("points changed on their way through columns", text);
}

void check_surface(const SurfaceFile& surface, std::string_view text) {
  const auto exists = [&](VertexId v) { return v.index() < surface.set.points.size(); };
  if (surface.offsets.front() != 0 || surface.offsets.back() != surface.corners.size() ||
      !std::is_sorted(surface.offsets.begin(), surface.offsets.end()) ||
      !std::all_of(surface.corners.begin(), surface.corners.end(), exists))
    report("a surface's polygons name vertices that do not exist", text);
  for (const std::size_t size : {surface.markers.size(), surface.facets.size()})
    if (size != 0 && size != surface.polygon_count())
      report("a surface's markers are not one a polygon", text);
  check_points(surface.set, text);
}

// ---- inputs ----

std::vector<fuzzing::Format> formats() {
  const TetMesh mesh = sample_mesh(true), plain = sample_mesh(false);
  const io::TetgenFileTexts tetgen = io::format_tetgen_files(mesh);
  using Text = const std::string&;
  return {{io::format_su2(plain), try_su2},
          {io::format_vtu(mesh), try_vtu},
          {ascii_vtu, try_vtu},
          {io::format_medit(mesh), try_medit},
          {medit, try_medit},
          {io::format_gmsh(plain, {io::GmshVersion::v2_2, false}), try_gmsh},
          {io::format_gmsh(plain, {io::GmshVersion::v2_2, true}), try_gmsh},
          {io::format_gmsh(plain, {io::GmshVersion::v4_1, false}), try_gmsh},
          {io::format_gmsh(plain, {io::GmshVersion::v4_1, true}), try_gmsh},
          {gmsh_with_gaps, try_gmsh},
          {plane_gmsh, try_plane_gmsh},
          {tetgen.node, [](Text text) { try_tetgen(text, 0); }},
          {tetgen.ele, [](Text text) { try_tetgen(text, 1); }},
          {*tetgen.face, [](Text text) { try_tetgen(text, 2); }},
          {off, [](Text text) { check_surface(io::parse_off(text, "fuzz"), text); }},
          {obj, [](Text text) { check_surface(io::parse_obj(text, "fuzz"), text); }},
          {jigsaw, [](Text text) { check_surface(io::parse_jigsaw(text, "fuzz"), text); }},
          {poly, [](Text text) { check_surface(io::parse_surface_poly(text, std::nullopt, "fuzz"), text); }},
          {smesh, [](Text text) { check_surface(io::parse_smesh(text, "1 3\n0 0 0 0\n", "fuzz"), text); }},
          {medit, [](Text text) { check_surface(io::parse_medit_surface(text, "fuzz"), text); }},
          {gmsh_with_gaps, [](Text text) { check_surface(io::parse_gmsh_surface(text, "fuzz"), text); }},
          {ascii_stl, [](Text text) { check_surface(io::parse_stl(text, "fuzz"), text); }},
          {binary_stl(), [](Text text) { check_surface(io::parse_stl(text, "fuzz"), text); }},
          {ply("ascii"), [](Text text) { check_surface(io::parse_ply(text, "fuzz"), text); }},
          {ply("binary_little_endian"), [](Text text) { check_surface(io::parse_ply(text, "fuzz"), text); }},
          {ply("binary_big_endian"), [](Text text) { check_surface(io::parse_ply(text, "fuzz"), text); }},
          {tetgen.node, [](Text text) { check_points(io::parse_node3(text, "fuzz").set, text); }},
          {"x,y,z\n1,2,3\n4,5,6\n", [](Text text) { check_points(io::parse_xyz(text, "fuzz").set, text); }}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzzing::try_formats(formats, data, size);
}
