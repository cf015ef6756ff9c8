// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/medit_data.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <set>
#include <utility>

#include "leonhard/mesh/io/did_you_mean.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

/// Sections that say nothing about which cells there are.
const std::vector<std::string>& harmless_sections() {
  static const std::vector<std::string> names{"Edges",
                                              "Corners",
                                              "Ridges",
                                              "RequiredVertices",
                                              "RequiredEdges",
                                              "RequiredTriangles",
                                              "Normals",
                                              "NormalAtVertices",
                                              "Tangents",
                                              "TangentAtVertices",
                                              "SubDomain",
                                              "SubDomainFromMesh",
                                              "SubDomainFromGeom",
                                              "VertexOnGeometricVertex",
                                              "VertexOnGeometricEdge",
                                              "Geometry",
                                              "AngleOfCornerBound",
                                              "RequiredQuadrilaterals",
                                              "RequiredTetrahedra",
                                              "LocalParametersAtVertices"};
  return names;
}

/// Cells that no tetrahedral mesh can have, as their sections are called.
constexpr std::array<std::string_view, 9> foreign_cells{"Hexahedra",        "Prisms",       "Pentahedra",
                                                        "Pyramids",         "TetrahedraP2", "TrianglesP2",
                                                        "QuadrilateralsQ2", "HexahedraQ2",  "Polyhedra"};

class MeditParser {
 public:
  MeditParser(std::string_view text, const std::string& source) : scan_(text, source, {.comment = '#'}) {
    data_.marker_names = read_marker_notes(text, '#');
  }

  MeditData parse() {
    bool more = scan_.next_line();
    while (more) {
      const std::string keyword(scan_.word("a keyword"));
      if (keyword == "End") break;
      if (!sections_.insert(keyword).second)
        scan_.fail("the section " + keyword + " comes a second time", "remove one of the two");
      more = read_section(keyword) ? next_section() : pass_over(keyword);
    }
    for (const char* section : {"MeshVersionFormatted", "Dimension", "Vertices"})
      if (!sections_.contains(section))
        scan_.fail(std::string("the file ends without a section ") + section,
                   "it was cut short, or is no mesh of Medit");
    return std::move(data_);
  }

 private:
  /// returns whether the section is one of those that are read
  bool read_section(const std::string& keyword) {
    if (keyword == "MeshVersionFormatted") return read_version(), true;
    if (keyword == "Dimension") return read_dimension(), true;
    if (keyword == "Vertices") return read_vertices(), true;
    if (keyword == "Triangles") return read_cells(data_.triangles, 3, "a triangle"), true;
    if (keyword == "Quadrilaterals") return read_cells(data_.quadrilaterals, 4, "a quadrilateral"), true;
    if (keyword == "Tetrahedra") return read_cells(data_.tetrahedra, 4, "a tetrahedron"), true;
    return false;
  }

  bool next_section() {
    scan_.expect_line_end("the section");
    return scan_.next_line();
  }

  void read_version() {
    scan_.need_word("the version");
    scan_.integer("the version");
  }

  void read_dimension() {
    scan_.need_word("the dimension");
    const std::int64_t dimension = scan_.integer("the dimension");
    if (dimension != 3)
      scan_.fail("Dimension " + std::to_string(dimension) + ": only meshes of space can be read here",
                 "give a mesh with Dimension 3");
  }

  std::size_t read_count(std::size_t bytes_each) {
    scan_.need_word("the number of entries");
    return scan_.count("the number of entries", bytes_each);
  }

  double coordinate() {
    scan_.need_word("a coordinate");
    return scan_.number("a coordinate");
  }

  Marker reference() {
    scan_.need_word("a reference");
    return scan_.integer32("a reference");
  }

  void read_vertices() {
    const std::size_t count = read_count(8);
    data_.points.reserve(count);
    data_.references.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = coordinate(), y = coordinate();
      data_.points.push_back({x, y, coordinate()});
      data_.references.push_back(reference());
    }
  }

  VertexId corner(const char* cell) {
    scan_.need_word(cell);
    const std::int64_t number = scan_.integer(cell);
    if (number < 1 || static_cast<std::uint64_t>(number) > std::numeric_limits<IdRaw>::max() - 1)
      scan_.fail("found vertex " + std::to_string(number) + " in " + cell, "vertices are numbered from 1");
    return VertexId::from(static_cast<std::size_t>(number - 1));
  }

  void read_cells(std::vector<MeditCell>& cells, std::size_t corners, const char* name) {
    const std::size_t count = read_count(2 * corners + 2);
    cells.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      MeditCell cell;
      for (std::size_t k = 0; k < corners; ++k) {
        cell.corners[k] = corner(name);
        if (k == 0) cell.line = static_cast<std::uint32_t>(scan_.line());
      }
      cell.reference = reference();
      cells.push_back(cell);
    }
  }

  /// Lines up to the next one that begins with a letter; returns whether there is one.
  bool pass_over(const std::string& keyword) {
    const auto& harmless = harmless_sections();
    const bool is_harmless = std::find(harmless.begin(), harmless.end(), keyword) != harmless.end();
    if (!is_harmless && std::find(foreign_cells.begin(), foreign_cells.end(), keyword) == foreign_cells.end())
      scan_.fail("the keyword " + in_quotes(keyword) + " is not known", suggestion(keyword));
    const std::string where = scan_.where();
    const std::size_t count = read_count(1);
    if (count > 0 && !is_harmless)
      scan_.fail("the file has " + std::to_string(count) + " " + keyword,
                 "only tetrahedra of four vertices, triangles and quadrilaterals can be read");
    if (count > 0)
      data_.warnings.push_back(where + ": the section " + keyword + " (" + std::to_string(count) +
                               " entries) was passed over");
    while (scan_.next_line())
      if (std::isalpha(static_cast<unsigned char>(scan_.rest().front())) != 0) return true;
    return false;
  }

  static std::string suggestion(const std::string& keyword) {
    std::vector<std::string> known{"MeshVersionFormatted", "Dimension",  "Vertices", "Triangles",
                                   "Quadrilaterals",       "Tetrahedra", "End"};
    known.insert(known.end(), harmless_sections().begin(), harmless_sections().end());
    return did_you_mean(keyword, known);
  }

  TextScanner scan_;
  MeditData data_;
  std::set<std::string> sections_;
};

}  // namespace

MeditData parse_medit_data(std::string_view text, const std::string& source) {
  return MeditParser(text, source).parse();
}

}  // namespace leonhard::io
