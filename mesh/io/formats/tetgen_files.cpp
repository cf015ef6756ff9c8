// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/tetgen_files.hpp"

#include <utility>
#include <vector>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/soup/tet_soup.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

// ---- reading ----

/// Corners as the next words of the line.
template <std::size_t corner_count>
std::array<VertexId, corner_count> read_corners(TextScanner& scan, const VertexTable3& vertices,
                                                const char* expected) {
  std::array<VertexId, corner_count> corners;
  for (VertexId& v : corners) v = VertexId::from(vertices.read_reference(scan, expected));
  return corners;
}

/// Tetrahedra with their regional attribute (the first one; 0 without).
void read_tetrahedra(TextScanner& scan, const VertexTable3& vertices, TetSoup& soup) {
  scan.need_line("the number of tetrahedra");
  const std::size_t count = scan.count("the number of tetrahedra", shortest_entry + 4);
  const std::int64_t nodes = scan.line_done() ? 4 : scan.integer("the number of nodes per tetrahedron");
  if (nodes != 4)
    scan.fail(nodes == 3 ? std::string("the cells have 3 nodes: this is a mesh of the plane")
                         : "tetrahedra have " + std::to_string(nodes) + " nodes, only 4 can be read",
              nodes == 3 ? "" : "write the mesh without mid-edge nodes (TetGen: without -o2)");
  const std::size_t attributes = scan.line_done() ? 0 : scan.count("the number of attributes", 1);
  scan.expect_line_end("the header of the tetrahedra");
  soup.cells.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line("a tetrahedron");
    check_number(scan, "tetrahedron", vertices.first_number + static_cast<std::int64_t>(i));
    const auto line = static_cast<std::uint32_t>(scan.line());
    soup.cells.push_back({read_corners<4>(scan, vertices, "a corner of a tetrahedron"), line});
    if (attributes > 0) {
      soup.cell_regions.push_back(scan.number("the attribute of a tetrahedron"));
      skip_attributes(scan, attributes - 1);
    }
    scan.expect_line_end("the tetrahedron");
  }
  expect_end(scan, "the last tetrahedron");
}

/// The faces of STEM.face. After the marker TetGen may write the tetrahedra on both sides.
void read_faces(TextScanner& scan, const VertexTable3& vertices, TetSoup& soup) {
  scan.need_line("the number of faces");
  const std::size_t count = scan.count("the number of faces", shortest_entry + 2);
  const bool with_markers = read_flag(scan, "the number of boundary markers");
  scan.expect_line_end("the header of the faces");
  soup.faces.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line("a face");
    check_number(scan, "face", vertices.first_number + static_cast<std::int64_t>(i));
    TetFace face;  // its line stays 0: errors of assemble name the .ele file
    face.corners = read_corners<3>(scan, vertices, "a corner of a face");
    if (with_markers) face.marker = scan.integer32("the boundary marker of a face");
    while (!scan.line_done()) scan.integer("a tetrahedron beside the face");
    soup.faces.push_back(face);
  }
  expect_end(scan, "the last face");
}

// ---- writing ----

std::string format_face(const TetMesh& mesh) {
  std::string text = format_marker_notes(mesh.marker_names, triangle_syntax.comment);
  append_words(text, {std::ssize(mesh.boundary) + std::ssize(mesh.interfaces), 1});
  end_line(text);
  std::int64_t number = 0;
  for (const std::vector<MarkedFace>* faces : {&mesh.boundary, &mesh.interfaces})
    for (const MarkedFace& face : *faces) {
      append_words(text, {number++});
      for (const VertexId v : face.corners) append_words(text, {static_cast<std::int64_t>(v.index())});
      append_words(text, {face.marker});
      end_line(text);
    }
  return text;
}

std::filesystem::path sibling(std::filesystem::path path, const char* extension) {
  return path.replace_extension(extension);
}

}  // namespace

TetMeshFile parse_tetgen_files(const TetgenFileTexts& texts, const std::string& source) {
  TextScanner node_scan(texts.node, source + ".node", triangle_syntax);
  VertexTable3 vertices = read_vertices3(node_scan);
  expect_end(node_scan, "the last vertex");
  TetSoup soup;
  soup.source = source + ".ele";
  if (vertices.first_number == 1) soup.note = "here ids are numbered from 0, in the files from 1";
  TextScanner ele_scan(texts.ele, soup.source, triangle_syntax);
  read_tetrahedra(ele_scan, vertices, soup);
  if (texts.face) {
    soup.marker_names = read_marker_notes(*texts.face, triangle_syntax.comment);
    TextScanner face_scan(*texts.face, source + ".face", triangle_syntax);
    read_faces(face_scan, vertices, soup);
  }
  soup.points = PerId<VertexId, Point3>(std::move(vertices.points));
  soup.vertex_markers = std::move(vertices.markers);
  return assemble(std::move(soup), FaceRule::fill_in_the_boundary);
}

TetMeshFile read_tetgen_files(const std::filesystem::path& path) {
  TetgenFileTexts texts;
  texts.node = read_whole_file(sibling(path, ".node"));
  texts.ele = read_whole_file(sibling(path, ".ele"));
  if (const std::filesystem::path face = sibling(path, ".face"); std::filesystem::exists(face))
    texts.face = read_whole_file(face);
  return parse_tetgen_files(texts, sibling(path, "").string());
}

TetgenFileTexts format_tetgen_files(const TetMesh& mesh) {
  TetgenFileTexts texts;
  append_vertices(texts.node, mesh.points.flat(), {}, mesh.vertex_markers.flat());
  texts.ele = format_ele(mesh.corners, mesh.regions);
  texts.face = format_face(mesh);
  texts.neigh = format_neigh(mesh.neighbours);
  return texts;
}

void write_tetgen_files(const std::filesystem::path& path, const TetMesh& mesh) {
  const TetgenFileTexts texts = format_tetgen_files(mesh);
  std::vector<AtomicFile> files;  // all are written before the first one appears
  const auto write = [&](const char* extension, const std::string& text) {
    files.emplace_back(sibling(path, extension)).write(text);
  };
  write(".node", texts.node);
  write(".ele", texts.ele);
  write(".face", *texts.face);
  write(".neigh", *texts.neigh);
  for (AtomicFile& file : files) file.commit();
}

}  // namespace leonhard::io
