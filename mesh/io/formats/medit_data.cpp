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
  static const std::vector<std::string> names{"Corners",
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
                                              "EdgeOnGeometricEdge",
                                              "TriangleOnGeometricTriangle",
                                              "CrackedEdges",
                                              "EquivalencedEdges",
                                              "PhysicsReference",
                                              "IncludeFile",
                                              "BoundingBox",
                                              "Geometry",
                                              "Identifier",
                                              "AngleOfCornerBound",
                                              "RequiredQuadrilaterals",
                                              "RequiredTetrahedra",
                                              "LocalParametersAtVertices"};
  return names;
}

/// A section of cells: how many vertices an entry has, the corners first.
struct MeditSection {
  std::string_view keyword;
  std::vector<MeditCell> MeditData::*list;
  std::size_t corners, vertices;
  const char* entry;
};

const std::array<MeditSection, 14> cell_sections{
    {{"Edges", &MeditData::edges, 2, 2, "an edge"},
     {"Triangles", &MeditData::triangles, 3, 3, "a triangle"},
     {"Quadrilaterals", &MeditData::quadrilaterals, 4, 4, "a quadrilateral"},
     {"Tetrahedra", &MeditData::tetrahedra, 4, 4, "a tetrahedron"},
     {"Hexahedra", &MeditData::hexahedra, 8, 8, "a hexahedron"},
     {"Prisms", &MeditData::prisms, 6, 6, "a prism"},
     {"Pentahedra", &MeditData::prisms, 6, 6, "a prism"},
     {"Pyramids", &MeditData::pyramids, 5, 5, "a pyramid"},
     {"EdgesP2", &MeditData::edges, 2, 3, "an edge"},
     {"TrianglesP2", &MeditData::triangles, 3, 6, "a triangle"},
     {"QuadrilateralsQ2", &MeditData::quadrilaterals, 4, 9, "a quadrilateral"},
     {"TetrahedraP2", &MeditData::tetrahedra, 4, 10, "a tetrahedron"},
     {"HexahedraQ2", &MeditData::hexahedra, 8, 27, "a hexahedron"},
     {"PrismsP2", &MeditData::prisms, 6, 18, "a prism"}}};

class MeditParser {
 public:
  MeditParser(std::string_view text, const std::string& source) : scan_(text, source, {.comment = '#'}) {
    data_.marker_names = read_marker_notes(text, '#');
    data_.region_names = read_marker_notes(text, '#', "region");
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
    if (of_higher_order_ > 0)
      data_.warnings.push_back(std::to_string(of_higher_order_) +
                               " cells are of higher order; they were read by their corners");
    if (dimension_of(data_) == 3 && !data_.edges.empty())
      data_.warnings.push_back("the section Edges (" + std::to_string(data_.edges.size()) +
                               " entries) was passed over");
    return std::move(data_);
  }

 private:
  /// returns whether the section is one of those that are read
  bool read_section(const std::string& keyword) {
    if (keyword == "MeshVersionFormatted") return read_version(), true;
    if (keyword == "Dimension") return read_dimension(), true;
    if (keyword == "Vertices") return read_vertices(), true;
    for (const MeditSection& section : cell_sections)
      if (keyword == section.keyword) return read_cells(section), true;
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
    if (dimension != 2 && dimension != 3)
      scan_.fail("Dimension " + std::to_string(dimension), "2 and 3 can be read");
    if (sections_.contains("Vertices")) scan_.fail("Dimension comes after Vertices", "put it first");
    data_.dimension = static_cast<int>(dimension);
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
    const std::size_t count = read_count(6);
    data_.points.reserve(count);
    data_.references.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = coordinate(), y = coordinate();
      data_.points.push_back({x, y, data_.dimension == 3 ? coordinate() : 0.0});
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

  void read_cells(const MeditSection& section) {
    const std::size_t count = read_count(2 * section.vertices + 2);
    std::vector<MeditCell>& cells = data_.*section.list;
    cells.reserve(cells.size() + count);
    for (std::size_t i = 0; i < count; ++i) {
      MeditCell cell;
      for (std::size_t k = 0; k < section.vertices; ++k) {
        const VertexId v = corner(section.entry);
        if (k < section.corners) cell.corners[k] = v;
        if (k == 0) cell.line = static_cast<std::uint32_t>(scan_.line());
      }
      cell.reference = reference();
      cells.push_back(cell);
    }
    if (section.vertices > section.corners) of_higher_order_ += count;
  }

  /// Lines up to the next one that begins with a letter; returns whether there is one.
  bool pass_over(const std::string& keyword) {
    const auto& harmless = harmless_sections();
    if (std::find(harmless.begin(), harmless.end(), keyword) == harmless.end())
      scan_.fail("the keyword " + in_quotes(keyword) + " is not known", suggestion(keyword));
    const std::string where = scan_.where();
    if (scan_.line_done() && !scan_.next_line()) return false;
    const bool is_text = scan_.rest().front() == '"';
    const std::int64_t count =
        is_text || keyword == "AngleOfCornerBound" ? 0 : scan_.integer("the number of entries");
    if (count > 0)
      data_.warnings.push_back(where + ": the section " + keyword + " (" + std::to_string(count) +
                               " entries) was passed over");
    while (scan_.next_line())
      if (std::isalpha(static_cast<unsigned char>(scan_.rest().front())) != 0) return true;
    return false;
  }

  static std::string suggestion(const std::string& keyword) {
    std::vector<std::string> known{"MeshVersionFormatted", "Dimension", "Vertices", "End"};
    for (const MeditSection& section : cell_sections) known.emplace_back(section.keyword);
    known.insert(known.end(), harmless_sections().begin(), harmless_sections().end());
    return did_you_mean(keyword, known);
  }

  TextScanner scan_;
  MeditData data_;
  std::set<std::string> sections_;
  std::size_t of_higher_order_ = 0;
};

}  // namespace

int dimension_of(const MeditData& data) {
  if (data.dimension == 2) return 2;
  for (const auto* cells : {&data.tetrahedra, &data.hexahedra, &data.prisms, &data.pyramids})
    if (!cells->empty()) return 3;
  const bool has_any = !data.edges.empty() || !data.triangles.empty() || !data.quadrilaterals.empty();
  const bool is_flat = std::all_of(data.points.begin(), data.points.end(),
                                   [&](const Point3& p) { return p.z == data.points[0].z; });
  return has_any && is_flat ? 2 : 3;
}

MeditData parse_medit_data(std::string_view text, const std::string& source) {
  return MeditParser(text, source).parse();
}

}  // namespace leonhard::io
