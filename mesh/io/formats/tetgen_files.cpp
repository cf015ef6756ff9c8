// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/tetgen_files.hpp"

#include <cstdint>
#include <limits>
#include <vector>

#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/stem_files.hpp"
#include "leonhard/mesh/io/formats/stem_soups.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

/// What follows the corners of a face: of second order three nodes more, the marker if there is one, and maybe the two
/// tetrahedra beside it. How many numbers there are tells which.
Marker marker_behind_corners(TextScanner& scan, bool with_markers) {
  std::vector<std::int64_t> numbers;
  while (!scan.line_done()) numbers.push_back(scan.integer("a number of a face"));
  if (!with_markers) return 0;
  const std::size_t at = numbers.size() == 4 || numbers.size() == 6 ? 3 : 0;
  if (numbers.size() <= at) scan.fail("the line ends where the boundary marker of a face was expected");
  if (numbers[at] < std::numeric_limits<Marker>::min() || numbers[at] > std::numeric_limits<Marker>::max())
    scan.fail("the marker " + std::to_string(numbers[at]) + " does not fit 32 bits");
  return static_cast<Marker>(numbers[at]);
}

/// The faces of STEM.face.
void read_faces(TextScanner& scan, const VertexTable<Point3>& vertices, MeshSoup<3>& soup) {
  scan.need_line("the number of faces");
  const std::size_t count = scan.count("the number of faces", shortest_entry + 2);
  const bool with_markers = read_flag(scan, "the number of boundary markers");
  scan.expect_line_end("the header of the faces");
  soup.mesh.boundary.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line("a face");
    check_number(scan, "face", vertices.first_number + static_cast<std::int64_t>(i));
    const auto corners = read_corners<3>(scan, vertices, "a corner of a face");
    soup.add_facet(corners, marker_behind_corners(scan, with_markers),
                   0);  // no line: errors of assemble name the .ele file
  }
  expect_end(scan, "the last face");
}

}  // namespace

MeshSoup<3> tetgen_soup(const TetgenFileTexts& texts, const std::string& source) {
  return parse_stem<3>(texts.node, texts.ele, source, [&](const auto& vertices, auto& soup) {
    if (!texts.face) return;
    soup.mesh.marker_names = read_marker_notes(*texts.face, triangle_syntax.comment);
    TextScanner face_scan(*texts.face, source + ".face", triangle_syntax);
    read_faces(face_scan, vertices, soup);
  });
}

TetMeshFile parse_tetgen_files(const TetgenFileTexts& texts, const std::string& source) {
  return assemble_simplices(tetgen_soup(texts, source));
}

MeshSoup<3> read_tetgen_soup(const std::filesystem::path& path) {
  TetgenFileTexts texts;
  texts.node = read_whole_file(sibling(path, ".node"));
  texts.ele = read_whole_file(sibling(path, ".ele"));
  texts.face = text_if_there(sibling(path, ".face"));
  return tetgen_soup(texts, sibling(path, "").string());
}

TetMeshFile read_tetgen_files(const std::filesystem::path& path) {
  return assemble_simplices(read_tetgen_soup(path));
}

TetgenFileTexts format_tetgen_files(const TetMesh& mesh) {
  TetgenFileTexts texts;
  append_vertices(texts.node, mesh.points.flat(), {}, mesh.vertex_markers.flat());
  texts.ele = format_marker_notes(mesh.region_names, triangle_syntax.comment, "region") +
              format_ele(mesh.corners, mesh.regions);
  texts.face = format_marker_notes(mesh.marker_names, triangle_syntax.comment);
  append_facets(*texts.face, mesh);
  texts.neigh = format_neigh(mesh.neighbours);
  return texts;
}

void write_tetgen_files(const std::filesystem::path& path, const TetMesh& mesh) {
  const TetgenFileTexts texts = format_tetgen_files(mesh);
  write_siblings(
      path,
      {{".node", &texts.node}, {".ele", &texts.ele}, {".face", &*texts.face}, {".neigh", &*texts.neigh}});
}

}  // namespace leonhard::io
