// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/medit.hpp"

#include <array>
#include <limits>
#include <span>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/medit_soup.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/formats/whole_regions.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

template <int Dim>
void add_medit_cells(const std::vector<MeditCell>& cells, CellKind kind, MeshSoup<Dim>& soup) {
  for (const MeditCell& cell : cells)
    soup.mesh
        .regions[soup.add_cell(kind, std::span(cell.corners).first(shape_of(kind).corner_count), cell.line)] =
        cell.reference;
}
template <int Dim>
void add_medit_facets(const std::vector<MeditCell>& facets, std::size_t corners, MeshSoup<Dim>& soup) {
  for (const MeditCell& facet : facets)
    soup.add_facet(std::span(facet.corners).first(corners), facet.reference, facet.line);
}

/// Corners, numbered from 1, and a reference.
template <class Corners>
void append_cell(std::string& text, const Corners& corners, Marker reference) {
  for (const VertexId v : corners) append_words(text, {static_cast<std::int64_t>(v.index()) + 1});
  append_words(text, {reference});
  end_line(text);
}

/// The sections of a mesh, cells and facets by kinds.
class MeditText {
 public:
  template <class Corners>
  void add(CellKind kind, const Corners& corners, Marker reference) {
    Section& section = sections_[static_cast<std::size_t>(kind)];
    append_cell(section.text, corners, reference);
    ++section.count;
  }
  void add_edge(const std::array<VertexId, 2>& corners, Marker reference) {
    append_cell(edges_.text, corners, reference);
    ++edges_.count;
  }
  [[nodiscard]] std::string finish() const {
    static constexpr std::array<const char*, cell_kind_count> names{
        "Triangles", "Quadrilaterals", "Tetrahedra", "Pyramids", "Prisms", "Hexahedra"};
    std::string text;
    const auto append = [&](const char* name, const Section& section) {
      if (section.count > 0)
        text += std::string(name) + "\n" + std::to_string(section.count) + "\n" + section.text;
    };
    append("Edges", edges_);
    for (std::size_t kind = 0; kind < cell_kind_count; ++kind) append(names[kind], sections_[kind]);
    return text;
  }

 private:
  struct Section {
    std::size_t count = 0;
    std::string text;
  };
  std::array<Section, cell_kind_count> sections_;
  Section edges_;
};

void add_facet(MeditText& text, const MarkedEdge& edge) {
  text.add_edge(Simplex<2>::corners_of(edge), edge.marker);
}
void add_facet(MeditText& text, const MarkedFace& face) {
  text.add(CellKind::triangle, face.corners, face.marker);
}
void add_facet(MeditText& text, const MarkedMixedFacet<2>& edge) {
  text.add_edge({edge.corners[0], edge.corners[1]}, edge.marker);
}
void add_facet(MeditText& text, const MarkedMixedFacet<3>& face) {
  text.add(face.corners.size() == 3 ? CellKind::triangle : CellKind::quadrilateral, face.corners,
           face.marker);
}

template <int Dim>
void add_cells(MeditText& text, const SimplexMesh<Dim>& mesh, const std::vector<Marker>& regions) {
  for (const auto t : mesh.corners.ids())
    text.add(simplex_kind<Dim>, mesh.corners[t], regions.empty() ? 0 : regions[t.index()]);
}
template <int Dim>
void add_cells(MeditText& text, const MixedMesh<Dim>& mesh, const std::vector<Marker>& regions) {
  for (const CellId cell : mesh.kinds.ids())
    text.add(mesh.kinds[cell], mesh.corners_of(cell), regions.empty() ? 0 : regions[cell.index()]);
}

template <int Dim>
const auto& inner_facets(const SimplexMesh<Dim>& mesh) {
  return mesh.inner_facets();
}
template <int Dim>
const auto& inner_facets(const MixedMesh<Dim>& mesh) {
  return mesh.inner_facets;
}

template <int Dim, class Mesh>
std::string medit_text(const Mesh& mesh) {
  const std::vector<Marker> regions = whole_regions(mesh.regions, std::numeric_limits<Marker>::min());
  std::string text =
      format_marker_notes(mesh.marker_names, '#') + format_marker_notes(mesh.region_names, '#', "region");
  text += "MeshVersionFormatted 2\nDimension " + std::to_string(Dim) + "\nVertices\n" +
          std::to_string(mesh.vertex_count()) + "\n";
  for (const VertexId v : mesh.points.ids()) {
    append_point(text, mesh.points[v]);
    append_words(text, {mesh.vertex_markers.empty() ? 0 : mesh.vertex_markers[v]});
    end_line(text);
  }
  MeditText sections;
  for (const auto* facets : {&mesh.boundary, &inner_facets(mesh)})
    for (const auto& facet : *facets) add_facet(sections, facet);
  add_cells(sections, mesh, regions);
  return text + sections.finish() + "End\n";
}

}  // namespace

template <int Dim>
MeshSoup<Dim> medit_soup(MeditData&& data, const std::string& source) {
  if (Dim == 2 ? dimension_of(data) != 2 : data.dimension != 3)
    throw InputError(source,
                     "Dimension " + std::to_string(data.dimension) + ": only meshes of " +
                         (Dim == 2 ? "the plane" : "space") + " can be read here",
                     "give a mesh with Dimension " + std::to_string(Dim));
  MeshSoup<Dim> soup;
  soup.source = source;
  soup.note = "here ids are numbered from 0, in the file from 1";
  soup.mesh.vertex_markers = PerId<VertexId, Marker>(std::move(data.references));
  soup.mesh.marker_names = std::move(data.marker_names);
  soup.mesh.region_names = std::move(data.region_names);
  soup.warnings = std::move(data.warnings);
  if constexpr (Dim == 2) {
    for (const Point3& p : data.points) soup.mesh.points.push_back({p.x, p.y});
    add_medit_cells(data.triangles, CellKind::triangle, soup);
    add_medit_cells(data.quadrilaterals, CellKind::quadrilateral, soup);
    add_medit_facets(data.edges, 2, soup);
  } else {
    soup.mesh.points = PerId<VertexId, Point3>(std::move(data.points));
    add_medit_cells(data.tetrahedra, CellKind::tetrahedron, soup);
    add_medit_cells(data.pyramids, CellKind::pyramid, soup);
    add_medit_cells(data.prisms, CellKind::prism, soup);
    add_medit_cells(data.hexahedra, CellKind::hexahedron, soup);
    add_medit_facets(data.triangles, 3, soup);
    add_medit_facets(data.quadrilaterals, 4, soup);
  }
  return soup;
}

template MeshSoup<2> medit_soup(MeditData&&, const std::string&);
template MeshSoup<3> medit_soup(MeditData&&, const std::string&);

TetMeshFile parse_medit(std::string_view text, const std::string& source) {
  return assemble_simplices(medit_soup<3>(parse_medit_data(text, source), source));
}
TetMeshFile read_medit(const std::filesystem::path& path) {
  return parse_medit(read_whole_file(path), path.string());
}

std::string format_medit(const TetMesh& mesh) { return medit_text<3>(mesh); }
std::string format_medit(const TriangleMesh& mesh) { return medit_text<2>(mesh); }
std::string format_medit(const MixedMesh<2>& mesh) { return medit_text<2>(mesh); }
std::string format_medit(const MixedMesh<3>& mesh) { return medit_text<3>(mesh); }

}  // namespace leonhard::io
