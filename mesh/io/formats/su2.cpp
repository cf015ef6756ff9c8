// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/su2.hpp"

#include <set>
#include <utility>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/soup/cell_soup.hpp"
#include "leonhard/mesh/io/soup/tet_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

// VTK's numbers, which SU2 uses.
constexpr std::int64_t line_type = 3, triangle_type = 5, quadrilateral_type = 9, tetrahedron_type = 10;

constexpr const char* partitioned = "this is one part of a partitioned mesh; give the whole";

// ---- reading ----

class TriangleParser final : Su2Parser {
 public:
  TriangleParser(std::string_view text, const std::string& source) : Su2Parser(text, source, 2) {
    soup_.source = source;
  }

  MeshFile parse() {
    read_sections();
    soup_.marker_names = std::move(names());
    MeshFile result = assemble(std::move(soup_), EdgeRule::edges_are_the_boundary);
    result.warnings.insert(result.warnings.begin(), warnings().begin(), warnings().end());
    return result;
  }

 private:
  void reserve(std::size_t cells, std::size_t points) override {
    soup_.cells.reserve(cells);
    soup_.points.reserve(points);
  }

  void read_cell(std::size_t index) override {
    const std::int64_t type = scan().integer("the type of a cell (5 triangle, 9 quadrilateral)");
    if (type != triangle_type && type != quadrilateral_type)
      scan().fail("cell " + std::to_string(index) + " has the type " + std::to_string(type) +
                      ", which is no cell of the plane",
                  "use 5 (triangle) or 9 (quadrilateral)");
    Cell cell;
    cell.corner_count = type == triangle_type ? 3 : 4;
    cell.line = static_cast<std::uint32_t>(scan().line());
    for (std::uint32_t i = 0; i < cell.corner_count; ++i)
      cell.corners[i] = read_vertex("a vertex of the cell");
    soup_.cells.push_back(cell);
  }

  void read_coordinates() override {
    const double x = scan().number("the x coordinate of a point");
    soup_.points.push_back({x, scan().number("the y coordinate of a point")});
  }

  void read_boundary_element(const std::string& tag, Marker marker) override {
    const std::int64_t type = scan().integer("the type of a boundary edge (3 line)");
    if (type != line_type)
      scan().fail("the marker " + in_quotes(tag) + " has an element of type " + std::to_string(type) +
                      ", but a boundary of the plane is made of lines",
                  type == 1 ? partitioned : "use 3 (line)");
    const VertexId from = read_vertex("a vertex of the boundary edge");
    soup_.edges.push_back({from, read_vertex("a vertex of the boundary edge"), marker});
  }

  void renumber(const std::vector<Marker>& number_of_tag) override {
    for (MarkedEdge& edge : soup_.edges)
      edge.marker = number_of_tag[static_cast<std::size_t>(edge.marker) - 1];
  }

  CellSoup soup_;
};

class TetParser final : Su2Parser {
 public:
  TetParser(std::string_view text, const std::string& source) : Su2Parser(text, source, 3) {
    soup_.source = source;
  }

  TetMeshFile parse() {
    read_sections();
    soup_.marker_names = std::move(names());
    TetMeshFile result = assemble(std::move(soup_), FaceRule::faces_are_the_boundary);
    result.warnings.insert(result.warnings.begin(), warnings().begin(), warnings().end());
    return result;
  }

 private:
  void reserve(std::size_t cells, std::size_t points) override {
    soup_.cells.reserve(cells);
    soup_.points.reserve(points);
  }

  void read_cell(std::size_t index) override {
    const std::int64_t type = scan().integer("the type of a cell (10 tetrahedron)");
    if (type != tetrahedron_type)
      scan().fail("cell " + std::to_string(index) + " has the type " + std::to_string(type) + name_of(type),
                  "only tetrahedra (10) can be read");
    TetCell cell;
    cell.line = static_cast<std::uint32_t>(scan().line());
    for (VertexId& v : cell.corners) v = read_vertex("a vertex of the cell");
    soup_.cells.push_back(cell);
  }

  static const char* name_of(std::int64_t type) {
    return type == 12 ? " (hexahedron)" : type == 13 ? " (prism)" : type == 14 ? " (pyramid)" : "";
  }

  void read_coordinates() override {
    const double x = scan().number("the x coordinate of a point"),
                 y = scan().number("the y coordinate of a point");
    soup_.points.push_back({x, y, scan().number("the z coordinate of a point")});
  }

  void read_boundary_element(const std::string& tag, Marker marker) override {
    const std::int64_t type = scan().integer("the type of a boundary face (5 triangle)");
    if (type != triangle_type)
      scan().fail("the marker " + in_quotes(tag) + " has an element of type " + std::to_string(type) +
                      ", but the boundary of tetrahedra is made of triangles",
                  type == 1 ? partitioned : "use 5 (triangle)");
    TetFace face{{}, marker, static_cast<std::uint32_t>(scan().line())};
    for (VertexId& v : face.corners) v = read_vertex("a vertex of the boundary face");
    soup_.faces.push_back(face);
  }

  void renumber(const std::vector<Marker>& number_of_tag) override {
    for (TetFace& face : soup_.faces) face.marker = number_of_tag[static_cast<std::size_t>(face.marker) - 1];
  }

  TetSoup soup_;
};

// ---- writing ----

/// How a mesh of the plane or of space is written: NDIME, types, and the vertices of an element of the boundary.
struct TriangleKind {
  static constexpr std::int64_t dimension = 2, cell = triangle_type, boundary = line_type;
  static std::array<VertexId, 2> vertices(const MarkedEdge& edge) { return {edge.from, edge.to}; }
};
struct TetKind {
  static constexpr std::int64_t dimension = 3, cell = tetrahedron_type, boundary = triangle_type;
  static std::array<VertexId, 3> vertices(const MarkedFace& face) { return face.corners; }
};

template <std::size_t count>
void append_element(std::string& text, std::int64_t type, const std::array<VertexId, count>& vertices) {
  append_words(text, {type});
  for (const VertexId v : vertices) append_words(text, {static_cast<std::int64_t>(v.index())});
}

template <class Kind, class Mesh>
std::string format(const Mesh& mesh) {
  std::map<Marker, std::vector<std::size_t>> elements_of;  // indices in mesh.boundary
  std::set<Marker> used;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    elements_of[mesh.boundary[i].marker].push_back(i);
    used.insert(mesh.boundary[i].marker);
  }
  const std::map<Marker, std::string> tags = su2_tags(mesh.marker_names, used);

  std::string text = format_marker_notes(tags, '%');
  text.reserve(text.size() + 64 * mesh.vertex_count() + 40 * mesh.corners.size());
  text +=
      "NDIME= " + std::to_string(Kind::dimension) + "\nNELEM= " + std::to_string(mesh.corners.size()) + "\n";
  for (const auto cell : mesh.corners.ids()) {
    append_element(text, Kind::cell, mesh.corners[cell]);
    append_words(text, {static_cast<std::int64_t>(cell.index())});
    end_line(text);
  }
  text += "NPOIN= " + std::to_string(mesh.vertex_count()) + "\n";
  for (const VertexId v : mesh.points.ids()) {
    append_point(text, mesh.points[v]);
    append_words(text, {static_cast<std::int64_t>(v.index())});
    end_line(text);
  }
  text += "NMARK= " + std::to_string(elements_of.size()) + "\n";
  for (const auto& [marker, elements] : elements_of) {
    text += "MARKER_TAG= " + tags.at(marker) + "\nMARKER_ELEMS= " + std::to_string(elements.size()) + "\n";
    for (const std::size_t i : elements) {
      append_element(text, Kind::boundary, Kind::vertices(mesh.boundary[i]));
      end_line(text);
    }
  }
  return text;
}

}  // namespace

MeshFile parse_su2(std::string_view text, const std::string& source) {
  return TriangleParser(text, source).parse();
}
TetMeshFile parse_tet_su2(std::string_view text, const std::string& source) {
  return TetParser(text, source).parse();
}

MeshFile read_su2(const std::filesystem::path& path) {
  return parse_su2(read_whole_file(path), path.string());
}
TetMeshFile read_tet_su2(const std::filesystem::path& path) {
  return parse_tet_su2(read_whole_file(path), path.string());
}

std::string format_su2(const TriangleMesh& mesh) { return format<TriangleKind>(mesh); }
std::string format_su2(const TetMesh& mesh) { return format<TetKind>(mesh); }

void write_su2(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_file_atomically(path, format_su2(mesh));
}
void write_su2(const std::filesystem::path& path, const TetMesh& mesh) {
  write_file_atomically(path, format_su2(mesh));
}

}  // namespace leonhard::io
