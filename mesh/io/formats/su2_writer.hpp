// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/su2_parser.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"

/// The text of SU2 meshes, whatever their cells. Not meant for callers of the room.
namespace leonhard::io {

template <class Vertices>
void append_su2_element(std::string& text, std::int64_t type, const Vertices& vertices) {
  append_words(text, {type});
  for (const VertexId v : vertices) append_words(text, {static_cast<std::int64_t>(v.index())});
}

/// A whole file.
///
/// cells         the ids of the mesh's cells
/// append_cell   called as append_cell(text, cell): the cell's type and vertices
/// append_facet  called as append_facet(text, facet) for those of mesh.boundary
/// throws  as su2_tags
template <int Dim, class Mesh, class Cells, class AppendCell, class AppendFacet>
[[nodiscard]] std::string su2_text(const Mesh& mesh, const Cells& cells, const AppendCell& append_cell,
                                   const AppendFacet& append_facet) {
  std::map<Marker, std::vector<std::size_t>> elements_of;  // indices in mesh.boundary
  std::set<Marker> used;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    elements_of[mesh.boundary[i].marker].push_back(i);
    used.insert(mesh.boundary[i].marker);
  }
  const std::map<Marker, std::string> tags = su2_tags(mesh.marker_names, used);

  std::string text = format_marker_notes(tags, '%');
  text.reserve(text.size() + 64 * mesh.vertex_count() + 40 * mesh.cell_count());
  text += "NDIME= " + std::to_string(Dim) + "\nNELEM= " + std::to_string(mesh.cell_count()) + "\n";
  for (const auto cell : cells) {
    append_cell(text, cell);
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
      append_facet(text, mesh.boundary[i]);
      end_line(text);
    }
  }
  return text;
}

}  // namespace leonhard::io
