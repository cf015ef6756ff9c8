// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/su2.hpp"

#include <utility>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/su2_writer.hpp"
#include "leonhard/mesh/io/formats/vtk_types.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

constexpr std::int64_t line_type = vtk_line, triangle_type = vtk_triangle,
                       quadrilateral_type = vtk_quadrilateral, tetrahedron_type = vtk_tetrahedron;

// ---- reading ----

/// What files of both dimensions have in common.
template <int Dim>
class MeshParser : Su2Parser {
 public:
  SimplexMeshFile<Dim> parse() {
    read_sections();
    soup_.marker_names = std::move(names());
    SimplexMeshFile<Dim> result = assemble(std::move(soup_), FacetRule::facets_are_the_boundary);
    result.warnings.insert(result.warnings.begin(), warnings().begin(), warnings().end());
    return result;
  }

 protected:
  MeshParser(std::string_view text, const std::string& source) : Su2Parser(text, source, Dim) {
    soup_.source = source;
  }
  ~MeshParser() = default;

  using Su2Parser::scan;

  void add_cell(std::uint32_t corner_count) {
    SoupCell cell{{}, corner_count, static_cast<std::uint32_t>(scan().line())};
    for (std::uint32_t i = 0; i < corner_count; ++i) cell.corners[i] = read_vertex("a vertex of the cell");
    soup_.cells.push_back(cell);
  }
  void add_facet(const char* a_vertex, Marker marker) {
    SoupFacet<Dim> facet{{}, marker, static_cast<std::uint32_t>(scan().line())};
    for (VertexId& v : facet.corners) v = read_vertex(a_vertex);
    soup_.facets.push_back(facet);
  }

 private:
  void read_coordinates() override { soup_.points.push_back(read_point<typename Simplex<Dim>::Point>()); }
  void reserve(std::size_t cells, std::size_t points) override {
    soup_.cells.reserve(cells);
    soup_.points.reserve(points);
  }
  void renumber(const std::vector<Marker>& number_of_tag) override {
    for (SoupFacet<Dim>& facet : soup_.facets)
      facet.marker = number_of_tag[static_cast<std::size_t>(facet.marker) - 1];
  }

  MeshSoup<Dim> soup_;
};

class TriangleParser final : public MeshParser<2> {
 public:
  TriangleParser(std::string_view text, const std::string& source) : MeshParser(text, source) {}

 private:
  void read_cell(std::size_t index) override {
    const std::int64_t type = scan().integer("the type of a cell (5 triangle, 9 quadrilateral)");
    if (type != triangle_type && type != quadrilateral_type)
      scan().fail("cell " + std::to_string(index) + " has the type " + std::to_string(type) +
                      ", which is no cell of the plane",
                  "use 5 (triangle) or 9 (quadrilateral)");
    add_cell(type == triangle_type ? 3 : 4);
  }

  void read_boundary_element(const std::string& tag, Marker marker) override {
    const std::int64_t type = scan().integer("the type of a boundary edge (3 line)");
    if (type != line_type)
      scan().fail("the marker " + in_quotes(tag) + " has an element of type " + std::to_string(type) +
                      ", but a boundary of the plane is made of lines",
                  type == 1 ? su2_partitioned : "use 3 (line)");
    add_facet("a vertex of the boundary edge", marker);
  }
};

class TetParser final : public MeshParser<3> {
 public:
  TetParser(std::string_view text, const std::string& source) : MeshParser(text, source) {}

 private:
  void read_cell(std::size_t index) override {
    const std::int64_t type = scan().integer("the type of a cell (10 tetrahedron)");
    if (type != tetrahedron_type)
      scan().fail("cell " + std::to_string(index) + " has the type " + std::to_string(type) + name_of(type),
                  "only tetrahedra (10) can be read");
    add_cell(4);
  }

  static const char* name_of(std::int64_t type) {
    return type == 12 ? " (hexahedron)" : type == 13 ? " (prism)" : type == 14 ? " (pyramid)" : "";
  }

  void read_boundary_element(const std::string& tag, Marker marker) override {
    const std::int64_t type = scan().integer("the type of a boundary face (5 triangle)");
    if (type != triangle_type)
      scan().fail("the marker " + in_quotes(tag) + " has an element of type " + std::to_string(type) +
                      ", but the boundary of tetrahedra is made of triangles",
                  type == 1 ? su2_partitioned : "use 5 (triangle)");
    add_facet("a vertex of the boundary face", marker);
  }
};

// ---- writing ----

template <int Dim>
std::string format(const SimplexMesh<Dim>& mesh) {
  return su2_text<Dim>(
      mesh, mesh.corners.ids(),
      [&](std::string& text, auto cell) {
        append_su2_element(text, Dim == 2 ? triangle_type : tetrahedron_type, mesh.corners[cell]);
      },
      [](std::string& text, const auto& facet) {
        append_su2_element(text, Dim == 2 ? line_type : triangle_type, Simplex<Dim>::corners_of(facet));
      });
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

std::string format_su2(const TriangleMesh& mesh) { return format(mesh); }
std::string format_su2(const TetMesh& mesh) { return format(mesh); }

void write_su2(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_file_atomically(path, format_su2(mesh));
}
void write_su2(const std::filesystem::path& path, const TetMesh& mesh) {
  write_file_atomically(path, format_su2(mesh));
}

}  // namespace leonhard::io
