// SPDX-License-Identifier: MIT
#include <utility>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/su2.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/su2_writer.hpp"
#include "leonhard/mesh/io/formats/vtk_types.hpp"
#include "leonhard/mesh/io/soup/mixed_soup.hpp"

namespace leonhard::io {
namespace {

/// Words for what a dimension's files hold.
template <int Dim>
struct MixedTerms;
template <>
struct MixedTerms<2> {
  static constexpr const char *cells = "5 (triangle) or 9 (quadrilateral)", *facets = "3 (line)",
                              *not_a_cell = ", which is no cell of the plane",
                              *not_a_facet = ", but a boundary of the plane is made of lines";
};
template <>
struct MixedTerms<3> {
  static constexpr const char *cells = "10 (tetrahedron), 12 (hexahedron), 13 (prism) or 14 (pyramid)",
                              *facets = "5 (triangle) or 9 (quadrilateral)",
                              *not_a_cell = ", which is no cell of space",
                              *not_a_facet =
                                  ", but a boundary of space is made of triangles and quadrilaterals";
};

template <int Dim>
class MixedParser final : Su2Parser {
 public:
  MixedParser(std::string_view text, const std::string& source) : Su2Parser(text, source, Dim) {
    soup_.source = source;
  }

  MixedMeshFile<Dim> parse() {
    read_sections();
    soup_.mesh.marker_names = std::move(names());
    soup_.warnings = std::move(warnings());
    return assemble(std::move(soup_), FacetRule::facets_are_the_boundary);
  }

 private:
  void read_cell(std::size_t index) override {
    const std::int64_t type = scan().integer("the type of a cell");
    const auto kind = kind_of_vtk_type(type);
    if (!kind || shape_of(*kind).dimension != Dim)
      scan().fail("cell " + std::to_string(index) + " has the type " + std::to_string(type) +
                      MixedTerms<Dim>::not_a_cell,
                  std::string("use ") + MixedTerms<Dim>::cells);
    std::array<VertexId, most_cell_corners> corners;
    const std::size_t count = shape_of(*kind).corner_count;
    for (std::size_t i = 0; i < count; ++i) corners[i] = read_vertex("a vertex of the cell");
    soup_.mesh.add_cell(*kind, std::span<const VertexId>(corners.data(), count));
    soup_.cell_lines.push_back(static_cast<std::uint32_t>(scan().line()));
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
                      MixedTerms<Dim>::not_a_facet,
                  type == 1 ? su2_partitioned : std::string("use ") + MixedTerms<Dim>::facets);
    std::array<VertexId, MixedFacet<Dim>::most_corners> corners;
    for (std::size_t i = 0; i < count; ++i) corners[i] = read_vertex("a vertex of the boundary element");
    soup_.mesh.boundary.push_back(
        {MixedFacet<Dim>(std::span<const VertexId>(corners.data(), count)), marker});
    soup_.facet_lines.push_back(static_cast<std::uint32_t>(scan().line()));
  }

  void reserve(std::size_t cells, std::size_t points) override {
    soup_.mesh.kinds.reserve(cells);
    soup_.mesh.points.reserve(points);
  }
  void renumber(const std::vector<Marker>& number_of_tag) override {
    for (auto& facet : soup_.mesh.boundary)
      facet.marker = number_of_tag[static_cast<std::size_t>(facet.marker) - 1];
  }

  MixedSoup<Dim> soup_;
};

std::int64_t vtk_type_of_facet(const MixedFacet<2>&) { return vtk_line; }
std::int64_t vtk_type_of_facet(const MixedFacet<3>& face) {
  return face.size() == 3 ? vtk_triangle : vtk_quadrilateral;
}

template <int Dim>
std::string format_mixed(const MixedMesh<Dim>& mesh) {
  return su2_text<Dim>(
      mesh, mesh.kinds.ids(),
      [&](std::string& text, CellId cell) {
        append_su2_element(text, vtk_type_of(mesh.kinds[cell]), mesh.corners_of(cell));
      },
      [](std::string& text, const auto& facet) {
        append_su2_element(text, vtk_type_of_facet(facet.corners), facet.corners);
      });
}

}  // namespace

template <int Dim>
MixedMeshFile<Dim> parse_mixed_su2(std::string_view text, const std::string& source) {
  return MixedParser<Dim>(text, source).parse();
}
template <int Dim>
MixedMeshFile<Dim> read_mixed_su2(const std::filesystem::path& path) {
  return parse_mixed_su2<Dim>(read_whole_file(path), path.string());
}

std::string format_su2(const MixedMesh<2>& mesh) { return format_mixed(mesh); }
std::string format_su2(const MixedMesh<3>& mesh) { return format_mixed(mesh); }
void write_su2(const std::filesystem::path& path, const MixedMesh<2>& mesh) {
  write_file_atomically(path, format_su2(mesh));
}
void write_su2(const std::filesystem::path& path, const MixedMesh<3>& mesh) {
  write_file_atomically(path, format_su2(mesh));
}

template MixedMeshFile<2> parse_mixed_su2<2>(std::string_view, const std::string&);
template MixedMeshFile<3> parse_mixed_su2<3>(std::string_view, const std::string&);
template MixedMeshFile<2> read_mixed_su2<2>(const std::filesystem::path&);
template MixedMeshFile<3> read_mixed_su2<3>(const std::filesystem::path&);

}  // namespace leonhard::io
