// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/su2.hpp"

#include <set>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/formats/vtk_types.hpp"

namespace leonhard::io {
namespace {

template <class Corners>
void append_su2_element(std::string& text, std::int64_t type, const Corners& vertices) {
  append_words(text, {type});
  for (const VertexId v : vertices) append_words(text, {static_cast<std::int64_t>(v.index())});
}

std::int64_t vtk_type_of_facet(const MixedFacet<2>&) { return vtk_line; }
std::int64_t vtk_type_of_facet(const MixedFacet<3>& face) {
  return face.size() == 3 ? vtk_triangle : vtk_quadrilateral;
}

template <int Dim>
void append_su2_cells(std::string& text, const SimplexMesh<Dim>& mesh) {
  for (const auto cell : mesh.corners.ids()) {
    append_su2_element(text, vtk_type_of(simplex_kind<Dim>), mesh.corners[cell]);
    append_words(text, {static_cast<std::int64_t>(cell.index())});
    end_line(text);
  }
}
template <int Dim>
void append_su2_cells(std::string& text, const MixedMesh<Dim>& mesh) {
  for (const CellId cell : mesh.kinds.ids()) {
    append_su2_element(text, vtk_type_of(mesh.kinds[cell]), mesh.corners_of(cell));
    append_words(text, {static_cast<std::int64_t>(cell.index())});
    end_line(text);
  }
}

void append_su2_facet(std::string& text, const MarkedEdge& edge) {
  append_su2_element(text, vtk_line, Simplex<2>::corners_of(edge));
}
void append_su2_facet(std::string& text, const MarkedFace& face) {
  append_su2_element(text, vtk_triangle, face.corners);
}
template <int Dim>
void append_su2_facet(std::string& text, const MarkedMixedFacet<Dim>& facet) {
  append_su2_element(text, vtk_type_of_facet(facet.corners), facet.corners);
}

template <class Mesh>
void append_su2_markers(std::string& text, const Mesh& mesh, const std::map<Marker, std::string>& tags) {
  std::map<Marker, std::vector<std::size_t>> elements_of;  // indices in mesh.boundary
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) elements_of[mesh.boundary[i].marker].push_back(i);
  text += "NMARK= " + std::to_string(elements_of.size()) + "\n";
  for (const auto& [marker, elements] : elements_of) {
    text += "MARKER_TAG= " + tags.at(marker) + "\nMARKER_ELEMS= " + std::to_string(elements.size()) + "\n";
    for (const std::size_t i : elements) {
      append_su2_facet(text, mesh.boundary[i]);
      end_line(text);
    }
  }
}

template <int Dim, class Mesh>
std::string su2_text(const Mesh& mesh) {
  std::set<Marker> used;
  for (const auto& facet : mesh.boundary) used.insert(facet.marker);
  const std::map<Marker, std::string> tags = su2_tags(mesh.marker_names, used);
  std::string text = format_marker_notes(tags, '%');
  text.reserve(text.size() + 64 * mesh.vertex_count() + 40 * mesh.cell_count());
  text += "NDIME= " + std::to_string(Dim) + "\nNELEM= " + std::to_string(mesh.cell_count()) + "\n";
  append_su2_cells(text, mesh);
  text += "NPOIN= " + std::to_string(mesh.vertex_count()) + "\n";
  for (const VertexId v : mesh.points.ids()) {
    append_point(text, mesh.points[v]);
    append_words(text, {static_cast<std::int64_t>(v.index())});
    end_line(text);
  }
  append_su2_markers(text, mesh, tags);
  return text;
}

}  // namespace

std::string format_su2(const TriangleMesh& mesh) { return su2_text<2>(mesh); }
std::string format_su2(const TetMesh& mesh) { return su2_text<3>(mesh); }
std::string format_su2(const MixedMesh<2>& mesh) { return su2_text<2>(mesh); }
std::string format_su2(const MixedMesh<3>& mesh) { return su2_text<3>(mesh); }

void write_su2(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_file_atomically(path, format_su2(mesh));
}
void write_su2(const std::filesystem::path& path, const TetMesh& mesh) {
  write_file_atomically(path, format_su2(mesh));
}
void write_su2(const std::filesystem::path& path, const MixedMesh<2>& mesh) {
  write_file_atomically(path, format_su2(mesh));
}
void write_su2(const std::filesystem::path& path, const MixedMesh<3>& mesh) {
  write_file_atomically(path, format_su2(mesh));
}

}  // namespace leonhard::io
