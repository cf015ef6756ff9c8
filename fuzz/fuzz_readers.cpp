// SPDX-License-Identifier: MIT
// Every reader of a file format either returns or throws InputError; what it returns passes the validators and
// survives its own writer. The input is a text of its own, or a list of edits to a valid text.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "fuzz/fuzz_text.hpp"
#include "leonhard/mesh/io/airfoil_dat.hpp"
#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/formats/triangle_files.hpp"
#include "leonhard/mesh/io/number_text.hpp"
#include "leonhard/mesh/io/soup/simple_polygon.hpp"
#include "leonhard/mesh/io/vtu.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/validate.hpp"

namespace {

using namespace leonhard;
using fuzzing::report;

// ---- valid texts ----

/// A square with a square hole: eight triangles, two boundaries, everything else a mesh may carry.
TriangleMesh sample_mesh() {
  PerId<VertexId, Point2> points(
      std::vector<Point2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}});
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  std::vector<MarkedEdge> boundary;
  for (IdRaw i = 0; i < 4; ++i) {
    const VertexId outer{i}, next_outer{(i + 1) % 4}, inner{4 + i}, next_inner{4 + (i + 1) % 4};
    corners.push_back({outer, next_outer, inner});
    corners.push_back({next_outer, next_inner, inner});
    boundary.push_back({outer, next_outer, 2});
    boundary.push_back({inner, next_inner, -5});
  }
  TriangleMesh mesh = mesh::make_triangle_mesh(points, corners, boundary, {{2, "outer"}, {-5, "hole"}});
  mesh.constraints = {{VertexId{0}, VertexId{4}, 9}};
  mesh.regions[TriangleId{1}] = 0.5;
  mesh.vertex_markers[VertexId{3}] = -1;
  return mesh;
}

constexpr const char* quadrilaterals_su2 =
    "NDIME= 2\nNELEM= 2\n9 0 1 4 3 0\n9 1 2 5 4 1\nNPOIN= 6\n0 0 0\n1 0 1\n2 0 2\n0 1 3\n1 1 4\n2 1 "
    "5\nNMARK= 2\n"
    "MARKER_TAG= a\nMARKER_ELEMS= 2\n3 0 1\n3 1 2\nMARKER_TAG= b\nMARKER_ELEMS= 4\n3 2 5\n3 5 4\n3 4 3\n3 3 "
    "0\n";

constexpr const char* ascii_vtu =
    "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"3\">"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 "
    "0</DataArray></Points>"
    "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 2 3 0 1</DataArray>"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6 8</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"binary\">AwAAAAUFAw==</DataArray></Cells>"
    "<CellData><DataArray type=\"Int32\" Name=\"marker\" format=\"ascii\">0 0 4</DataArray></CellData>"
    "</Piece></UnstructuredGrid></VTKFile>";

constexpr const char* geometry_poly =
    "# marker 3 wall\n5 2 1 1\n1 0 0 1 3\n2 1 0 1 3\n3 1 1 1 3\n4 0 1 1 3\n5 .5 .5 1 0\n5 1\n1 1 2 3\n2 2 3 "
    "3\n3 3 4 3\n4 4 1 3\n"
    "5 1 5 0\n1\n1 0.75 0.5\n1\n1 0.1 0.2 7 0.01\n";

constexpr const char* selig = "name\n1 0.01\n0.5 0.1\n0.1 0.08\n0 0\n0.1 -0.04\n0.5 -0.05\n1 -0.01\n";
constexpr const char* lednicer = "4 4\n0 0\n0.1 0.08\n0.5 0.1\n1 0\n0 0\n0.1 -0.04\n0.5 -0.05\n1 0\n";

// ---- properties ----

auto sorted(std::vector<MarkedEdge> edges) {
  std::sort(edges.begin(), edges.end(), [](const MarkedEdge& a, const MarkedEdge& b) {
    return std::tie(a.from, a.to, a.marker) < std::tie(b.from, b.to, b.marker);
  });
  return edges;
}

void check_mesh(const TriangleMesh& mesh, std::string_view text) {
  if (const auto broken = mesh::validate(mesh)) report("a reader returned an invalid mesh: " + *broken, text);
  if (const auto overlap = mesh::validate_embedding(mesh))
    report("a reader returned a tangled mesh: " + *overlap, text);
}

void check_same(const TriangleMesh& a, const TriangleMesh& b, std::string_view text) {
  if (!(a.points == b.points && a.corners == b.corners && sorted(a.boundary) == sorted(b.boundary) &&
        a.constraints == b.constraints && a.marker_names == b.marker_names && a.regions == b.regions &&
        a.vertex_markers == b.vertex_markers))
    report("a mesh changed on its way through its own format", text);
}

void try_su2(const std::string& text) {
  const TriangleMesh mesh = io::parse_su2(text, "fuzz").mesh;
  check_mesh(mesh, text);
  const TriangleMesh again = io::parse_su2(io::format_su2(mesh), "again").mesh;
  if (mesh.constraints.empty()) check_same(mesh, again, text);  // inner edges are read and not written
}

void try_vtu(const std::string& text) {
  const TriangleMesh mesh = io::parse_vtu(text, "fuzz").mesh;
  check_mesh(mesh, text);
  check_same(mesh, io::parse_vtu(io::format_vtu(mesh), "again").mesh, text);
}

/// One of the files is the fuzzed text, the others are right.
void try_triangle_files(const std::string& text, std::uint8_t which) {
  io::TriangleFileTexts texts = io::format_triangle_files(sample_mesh());
  if (which % 4 == 0) texts.node = text;
  if (which % 4 == 1) texts.ele = text;
  if (which % 4 == 2) texts.poly = text;
  if (which % 4 == 3) {
    texts.poly.reset();
    texts.edge = text;
  }
  const TriangleMesh mesh = io::parse_triangle_files(texts, "fuzz").mesh;
  check_mesh(mesh, text);
  check_same(mesh, io::parse_triangle_files(io::format_triangle_files(mesh), "again").mesh, text);
}

void try_poly(const std::string& text) {
  const Pslg pslg = io::parse_poly(text, std::string("2 2 0 0\n0 0 0\n1 1 1\n"), "fuzz");
  if (io::parse_poly(io::format_poly(pslg), std::nullopt, "fuzz") != pslg && !pslg.points.empty())
    report("a geometry changed on its way through .poly", text);
}

void try_airfoil(const std::string& text) {
  const AirfoilCoordinates airfoil = io::parse_airfoil(text, "fuzz");
  if (airfoil.points.size() < 5) report("an airfoil has too few points", text);
  if (io::edges_that_meet(airfoil.points)) report("an airfoil crosses itself", text);
  if (!io::is_counter_clockwise(airfoil.points)) report("an airfoil runs clockwise", text);
  std::string again = "again\n";
  for (std::size_t i = 0; i <= airfoil.points.size(); ++i) {
    const Point2 p = airfoil.points[i % airfoil.points.size()];
    io::append_number(again, p.x);
    again += ' ';
    io::append_number(again, p.y);
    again += '\n';
  }
  if (io::parse_airfoil(again, "again").points.size() != airfoil.points.size())
    report("an airfoil changed on its way through a closed curve", text);
}

// ---- inputs ----

std::vector<fuzzing::Format> formats() {
  const TriangleMesh mesh = sample_mesh();
  const io::TriangleFileTexts texts = io::format_triangle_files(mesh);
  return {{io::format_su2(mesh), try_su2},
          {quadrilaterals_su2, try_su2},
          {io::format_vtu(mesh), try_vtu},
          {ascii_vtu, try_vtu},
          {texts.node, [](const std::string& text) { try_triangle_files(text, 0); }},
          {texts.ele, [](const std::string& text) { try_triangle_files(text, 1); }},
          {*texts.poly, [](const std::string& text) { try_triangle_files(text, 2); }},
          {"1 1\n0 0 1 3\n", [](const std::string& text) { try_triangle_files(text, 3); }},
          {geometry_poly, try_poly},
          {selig, try_airfoil},
          {lednicer, try_airfoil}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzzing::try_formats(formats, data, size);
}
