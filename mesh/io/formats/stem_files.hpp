// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/soup/mesh_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

/// Meshes as the files STEM.node, STEM.ele, ... of Triangle and TetGen: what the two formats share.
namespace leonhard::io {

[[nodiscard]] inline std::filesystem::path sibling(std::filesystem::path path, const char* extension) {
  return path.replace_extension(extension);
}

[[nodiscard]] inline std::optional<std::string> text_if_there(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  return read_whole_file(path);
}

/// All are written before the first one appears.
inline void write_siblings(const std::filesystem::path& path,
                           const std::vector<std::pair<const char*, const std::string*>>& texts) {
  std::vector<AtomicFile> files;
  for (const auto& [extension, text] : texts) files.emplace_back(sibling(path, extension)).write(*text);
  for (AtomicFile& file : files) file.commit();
}

/// Corners as the next words of the line.
template <std::size_t corner_count, class Point>
[[nodiscard]] std::array<VertexId, corner_count> read_corners(TextScanner& scan,
                                                              const VertexTable<Point>& vertices,
                                                              const char* expected) {
  std::array<VertexId, corner_count> corners;
  for (VertexId& v : corners) v = VertexId::from(vertices.read_reference(scan, expected));
  return corners;
}

/// The cells of an .ele file with their regional attribute (the first one; 0 without).
template <int Dim>
void read_cells(TextScanner& scan, const VertexTable<typename Simplex<Dim>::Point>& vertices,
                MeshSoup<Dim>& soup) {
  const std::string cell = Simplex<Dim>::cell, cells = Simplex<Dim>::cells;
  const std::string number_of_cells = "the number of " + cells, a_cell = "a " + cell,
                    a_corner = "a corner of a " + cell, an_attribute = "the attribute of a " + cell;
  scan.need_line(number_of_cells.c_str());
  const std::size_t count = scan.count(number_of_cells.c_str(), shortest_entry + 2 * (Dim - 1));
  const std::int64_t nodes =
      scan.line_done() ? Dim + 1 : scan.integer(("the number of nodes per " + cell).c_str());
  if (Dim == 3 && (nodes == 3 || nodes == 6))
    scan.fail("the cells have 3 corners: this is a mesh of the plane");
  constexpr std::int64_t nodes_of_second_order = Dim == 2 ? 6 : 10;  // corners first
  if (nodes != Dim + 1 && nodes != nodes_of_second_order)
    scan.fail(cells + " have " + std::to_string(nodes) + " nodes",
              "they can have " + std::to_string(Dim + 1) + " or " + std::to_string(nodes_of_second_order));
  const std::size_t attributes = scan.line_done() ? 0 : scan.count("the number of attributes", 1);
  scan.expect_line_end(("the header of the " + cells).c_str());
  soup.mesh.kinds.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line(a_cell.c_str());
    check_number(scan, cell.c_str(), vertices.first_number + static_cast<std::int64_t>(i));
    const auto corners = read_corners<Dim + 1>(scan, vertices, a_corner.c_str());
    for (std::int64_t k = Dim + 1; k < nodes; ++k) (void)vertices.read_reference(scan, "a node of a cell");
    const CellId id = soup.add_cell(simplex_kind<Dim>, corners, scan.line());
    if (attributes > 0) {
      soup.mesh.regions[id] = scan.number(an_attribute.c_str());
      skip_attributes(scan, attributes - 1);
    }
    scan.expect_line_end(("the " + cell).c_str());
  }
  if (nodes > Dim + 1)
    soup.warnings.push_back(std::to_string(count) +
                            " cells are of second order; they were read by their corners");
  expect_end(scan, ("the last " + cell).c_str());
}

/// What a .node and an .ele text state.
///
/// read_facets  called with the vertices and the soup, to add the marked facets and names of other files
template <int Dim, class ReadFacets>
[[nodiscard]] MeshSoup<Dim> parse_stem(const std::string& node, const std::string& ele,
                                       const std::string& stem, ReadFacets read_facets) {
  TextScanner node_scan(node, stem + ".node", triangle_syntax);
  auto vertices = read_vertices<typename Simplex<Dim>::Point>(node_scan);
  expect_end(node_scan, "the last vertex");
  MeshSoup<Dim> soup;
  soup.source = stem + ".ele";
  if (vertices.first_number == 1) soup.note = "here ids are numbered from 0, in the files from 1";
  TextScanner ele_scan(ele, soup.source, triangle_syntax);
  read_cells(ele_scan, vertices, soup);
  read_facets(vertices, soup);
  soup.mesh.region_names = read_marker_notes(ele, triangle_syntax.comment, "region");
  soup.mesh.points = PerId<VertexId, typename Simplex<Dim>::Point>(std::move(vertices.points));
  soup.mesh.vertex_markers = PerId<VertexId, Marker>(std::move(vertices.markers));
  return soup;
}

/// Their count and a line each, numbered from 0: the boundary and the inner facets with their markers.
template <int Dim>
void append_facets(std::string& text, const SimplexMesh<Dim>& mesh) {
  append_words(text, {std::ssize(mesh.boundary) + std::ssize(mesh.inner_facets()), 1});
  end_line(text);
  std::int64_t number = 0;
  for (const auto* facets : {&mesh.boundary, &mesh.inner_facets()})
    for (const auto& facet : *facets) {
      append_words(text, {number++});
      for (const VertexId v : Simplex<Dim>::corners_of(facet))
        append_words(text, {static_cast<std::int64_t>(v.index())});
      append_words(text, {facet.marker});
      end_line(text);
    }
}

}  // namespace leonhard::io
