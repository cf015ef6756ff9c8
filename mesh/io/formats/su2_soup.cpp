// SPDX-License-Identifier: MIT
#include <array>
#include <span>
#include <utility>

#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/su2_soup.hpp"
#include "leonhard/mesh/io/formats/vtk_types.hpp"

namespace leonhard::io {
namespace {

/// Words for what a dimension's files hold.
template <int Dim>
struct Su2Terms;
template <>
struct Su2Terms<2> {
  static constexpr const char *cells = "5 (triangle) or 9 (quadrilateral)", *facets = "3 (line)",
                              *not_a_cell = ", which is no cell of the plane",
                              *not_a_facet = ", but a boundary of the plane is made of lines";
};
template <>
struct Su2Terms<3> {
  static constexpr const char *cells = "10 (tetrahedron), 12 (hexahedron), 13 (prism) or 14 (pyramid)",
                              *facets = "5 (triangle) or 9 (quadrilateral)",
                              *not_a_cell = ", which is no cell of space",
                              *not_a_facet =
                                  ", but a boundary of space is made of triangles and quadrilaterals";
};

template <int Dim>
class Su2SoupParser final : Su2Parser {
 public:
  Su2SoupParser(std::string_view text, const Su2Zone& zone, const std::string& source)
      : Su2Parser(text, zone, source, Dim) {
    soup_.source = source;
  }

  MeshSoup<Dim> parse() {
    read_sections();
    soup_.mesh.marker_names = std::move(names());
    soup_.warnings = std::move(warnings());
    return std::move(soup_);
  }

 private:
  void read_cell(std::size_t index) override {
    const std::int64_t type = scan().integer("the type of a cell");
    const auto kind = kind_of_vtk_type(type);
    if (!kind || shape_of(*kind).dimension != Dim)
      scan().fail("cell " + std::to_string(index) + " has the type " + std::to_string(type) +
                      Su2Terms<Dim>::not_a_cell,
                  std::string("use ") + Su2Terms<Dim>::cells);
    std::array<VertexId, most_cell_corners> corners;
    const std::size_t count = shape_of(*kind).corner_count;
    for (std::size_t i = 0; i < count; ++i) corners[i] = read_vertex("a vertex of the cell");
    soup_.add_cell(*kind, std::span<const VertexId>(corners.data(), count), scan().line());
  }

  void read_coordinates() override {
    soup_.mesh.points.push_back(read_point<typename Simplex<Dim>::Point>());
  }

  void read_boundary_element(const std::string& tag, Marker marker) override {
    const std::int64_t type = scan().integer("the type of a boundary element");
    const std::size_t count = Dim == 2 ? (type == vtk_line ? 2 : 0)
                                       : (type == vtk_triangle        ? 3
                                          : type == vtk_quadrilateral ? 4
                                                                      : 0);
    if (count == 0)
      scan().fail("the marker " + in_quotes(tag) + " has an element of type " + std::to_string(type) +
                      Su2Terms<Dim>::not_a_facet,
                  std::string("use ") + Su2Terms<Dim>::facets);
    std::array<VertexId, MixedFacet<Dim>::most_corners> corners;
    for (std::size_t i = 0; i < count; ++i) corners[i] = read_vertex("a vertex of the boundary element");
    soup_.add_facet(std::span<const VertexId>(corners.data(), count), marker, scan().line());
  }

  void reserve(std::size_t cells, std::size_t points) override {
    soup_.mesh.kinds.reserve(cells);
    soup_.mesh.points.reserve(points);
  }
  void renumber(const std::vector<Marker>& number_of_tag) override {
    for (auto& facet : soup_.mesh.boundary)
      facet.marker = number_of_tag[static_cast<std::size_t>(facet.marker) - 1];
  }

  MeshSoup<Dim> soup_;
};

}  // namespace

template <int Dim>
MeshSoup<Dim> parse_su2_soup(std::string_view text, const std::string& source,
                             std::optional<std::size_t> zone) {
  return Su2SoupParser<Dim>(text, find_su2_zone(text, source, zone), source).parse();
}

MeshFile parse_su2(std::string_view text, const std::string& source) {
  return assemble_simplices(parse_su2_soup<2>(text, source));
}
TetMeshFile parse_tet_su2(std::string_view text, const std::string& source) {
  return assemble_simplices(parse_su2_soup<3>(text, source));
}
template <int Dim>
MixedMeshFile<Dim> parse_mixed_su2(std::string_view text, const std::string& source) {
  return assemble_mixed(parse_su2_soup<Dim>(text, source));
}

MeshFile read_su2(const std::filesystem::path& path) {
  return parse_su2(read_whole_file(path), path.string());
}
TetMeshFile read_tet_su2(const std::filesystem::path& path) {
  return parse_tet_su2(read_whole_file(path), path.string());
}
template <int Dim>
MixedMeshFile<Dim> read_mixed_su2(const std::filesystem::path& path) {
  return parse_mixed_su2<Dim>(read_whole_file(path), path.string());
}

template MeshSoup<2> parse_su2_soup(std::string_view, const std::string&, std::optional<std::size_t>);
template MeshSoup<3> parse_su2_soup(std::string_view, const std::string&, std::optional<std::size_t>);
template MixedMeshFile<2> parse_mixed_su2<2>(std::string_view, const std::string&);
template MixedMeshFile<3> parse_mixed_su2<3>(std::string_view, const std::string&);
template MixedMeshFile<2> read_mixed_su2<2>(const std::filesystem::path&);
template MixedMeshFile<3> read_mixed_su2<3>(const std::filesystem::path&);

}  // namespace leonhard::io
