// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/medit.hpp"

#include <limits>
#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/medit_data.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/formats/whole_regions.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

MeshSoup<3> soup_of(MeditData data, const std::string& source) {
  MeshSoup<3> soup;
  soup.source = source;
  soup.note = "here ids are numbered from 0, in the file from 1";
  soup.points = PerId<VertexId, Point3>(std::move(data.points));
  soup.vertex_markers = std::move(data.references);
  soup.marker_names = std::move(data.marker_names);
  soup.cells.reserve(data.tetrahedra.size());
  soup.cell_regions.reserve(data.tetrahedra.size());
  for (const MeditCell& cell : data.tetrahedra) {
    soup.cells.push_back({cell.corners, 4, cell.line});
    soup.cell_regions.push_back(cell.reference);
  }
  soup.facets.reserve(data.triangles.size());
  for (const MeditCell& face : data.triangles)
    soup.facets.push_back({{face.corners[0], face.corners[1], face.corners[2]}, face.reference, face.line});
  return soup;
}

/// Corners, numbered from 1, and a reference.
template <std::size_t corner_count>
void append_cell(std::string& text, const std::array<VertexId, corner_count>& corners, Marker reference) {
  for (const VertexId v : corners) append_words(text, {static_cast<std::int64_t>(v.index()) + 1});
  append_words(text, {reference});
  end_line(text);
}

}  // namespace

TetMeshFile parse_medit(std::string_view text, const std::string& source) {
  MeditData data = parse_medit_data(text, source);
  if (!data.quadrilaterals.empty())
    throw InputError(at_line(source, data.quadrilaterals.front().line), "the file has Quadrilaterals",
                     "a tetrahedral mesh has none");
  std::vector<std::string> warnings = std::move(data.warnings);
  TetMeshFile result = assemble(soup_of(std::move(data), source), FacetRule::fill_in_the_boundary);
  result.warnings.insert(result.warnings.begin(), warnings.begin(), warnings.end());
  return result;
}

TetMeshFile read_medit(const std::filesystem::path& path) {
  return parse_medit(read_whole_file(path), path.string());
}

std::string format_medit(const TetMesh& mesh) {
  const std::vector<Marker> regions = whole_regions(mesh.regions, std::numeric_limits<Marker>::min());
  std::string text = format_marker_notes(mesh.marker_names, '#');
  text += "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(mesh.vertex_count()) + "\n";
  for (const VertexId v : mesh.points.ids()) {
    append_point(text, mesh.points[v]);
    append_words(text, {mesh.vertex_markers.empty() ? 0 : mesh.vertex_markers[v]});
    end_line(text);
  }
  text += "Triangles\n" + std::to_string(mesh.boundary.size() + mesh.interfaces.size()) + "\n";
  for (const std::vector<MarkedFace>* faces : {&mesh.boundary, &mesh.interfaces})
    for (const MarkedFace& face : *faces) append_cell(text, face.corners, face.marker);
  text += "Tetrahedra\n" + std::to_string(mesh.tet_count()) + "\n";
  for (const TetId t : mesh.corners.ids())
    append_cell(text, mesh.corners[t], regions.empty() ? 0 : regions[t.index()]);
  return text + "End\n";
}

void write_medit(const std::filesystem::path& path, const TetMesh& mesh) {
  write_file_atomically(path, format_medit(mesh));
}

}  // namespace leonhard::io
