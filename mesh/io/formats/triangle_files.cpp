// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/triangle_files.hpp"

#include <utility>

#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/io/formats/marker_notes.hpp"
#include "leonhard/mesh/io/formats/stem_files.hpp"
#include "leonhard/mesh/io/formats/stem_soups.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

constexpr TextSyntax syntax = triangle_syntax;

// ---- reading ----

/// Segments of a .poly file or edges of an .edge file.
///
/// warnings  gets those from a vertex to itself, which are left out
std::vector<Pslg::Segment> read_segments(TextScanner& scan, const VertexTable<Point2>& vertices,
                                         std::vector<std::string>& warnings) {
  scan.need_line("the number of segments");
  const std::size_t count = scan.count("the number of segments", shortest_entry);
  const bool with_markers = read_flag(scan, "the number of boundary markers");
  scan.expect_line_end("the header of the segments");
  std::vector<Pslg::Segment> segments;
  segments.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line("a segment");
    const std::int64_t number = scan.integer("the number of a segment");
    Pslg::Segment segment;
    segment.from = vertices.read_reference(scan, "the first vertex of a segment");
    segment.to = vertices.read_reference(scan, "the second vertex of a segment");
    if (with_markers) segment.marker = scan.integer32("the boundary marker of a segment");
    scan.expect_line_end("the segment");
    if (segment.from == segment.to) {
      warnings.push_back(scan.where() + ": both ends of segment " + std::to_string(number) +
                         " are the same vertex; it was left out");
      continue;
    }
    segments.push_back(segment);
  }
  return segments;
}

Point2 read_seed(TextScanner& scan) {
  const double x = scan.number("an x coordinate");
  const double y = scan.number("a y coordinate");
  return {x, y};
}

std::vector<Point2> read_holes(TextScanner& scan) {
  scan.need_line("the number of holes");
  const std::size_t count = scan.count("the number of holes", shortest_entry);
  scan.expect_line_end("the number of holes");
  std::vector<Point2> holes;
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line("a hole");
    scan.integer("the number of a hole");
    holes.push_back(read_seed(scan));
    scan.expect_line_end("the hole");
  }
  return holes;
}

std::vector<Pslg::Region> read_regions(TextScanner& scan) {
  std::vector<Pslg::Region> regions;
  if (!scan.next_line()) return regions;  // the section is optional
  const std::size_t count = scan.count("the number of regions", shortest_entry);
  scan.expect_line_end("the number of regions");
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line("a region");
    scan.integer("the number of a region");
    Pslg::Region region;
    region.seed = read_seed(scan);
    region.attribute = scan.number("the attribute of a region");
    const double area = scan.line_done() ? region.attribute : scan.number("the largest area of a region");
    region.max_area = area > 0 ? area : -1;
    scan.expect_line_end("the region");
    regions.push_back(region);
  }
  return regions;
}

/// The marked edges of STEM.poly, or of STEM.edge; those of a .poly with points of its own are not the
/// mesh's.
void read_marked_edges(const TriangleFileTexts& texts, const std::string& source,
                       const VertexTable<Point2>& vertices, MeshSoup<2>& soup) {
  std::vector<Pslg::Segment> segments;
  if (texts.poly) {
    soup.mesh.marker_names = read_marker_notes(*texts.poly, syntax.comment);
    TextScanner scan(*texts.poly, source + ".poly", syntax);
    if (read_vertices<Point2>(scan).points.empty()) {
      segments = read_segments(scan, vertices, soup.warnings);
    } else {
      soup.warnings.push_back(
          source + ".poly holds points of its own: it is the geometry, and its markers were not read");
    }
  } else if (texts.edge) {
    TextScanner scan(*texts.edge, source + ".edge", syntax);
    segments = read_segments(scan, vertices, soup.warnings);
    std::erase_if(segments, [](const Pslg::Segment& edge) { return edge.marker == 0; });
  }
  for (const Pslg::Segment& s : segments)
    soup.add_facet(std::array{VertexId::from(s.from), VertexId::from(s.to)}, s.marker, 0);
}

// ---- writing ----

std::string format_mesh_poly(const TriangleMesh& mesh) {
  std::string text = format_marker_notes(mesh.marker_names, syntax.comment);
  text += "# the vertices are in the .node file\n0 2 0 1\n";
  append_facets(text, mesh);
  return text + "0\n";
}

}  // namespace

Pslg parse_poly(std::string_view poly, const std::optional<std::string>& node, const std::string& source,
                std::vector<std::string>* warnings) {
  TextScanner scan(poly, source, syntax);
  VertexTable<Point2> vertices = read_vertices<Point2>(scan);
  if (vertices.points.empty()) {
    if (!node)
      scan.fail("the file declares 0 vertices, and there is no .node file beside it",
                "add the .node file of the same name, or the vertices");
    TextScanner node_scan(*node, std::filesystem::path(source).replace_extension(".node").string(), syntax);
    vertices = read_vertices<Point2>(node_scan);
    expect_end(node_scan, "the last vertex");
  }
  Pslg pslg;
  std::vector<std::string> left_out;
  pslg.segments = read_segments(scan, vertices, left_out);
  if (warnings != nullptr) warnings->insert(warnings->end(), left_out.begin(), left_out.end());
  pslg.holes = read_holes(scan);
  pslg.regions = read_regions(scan);
  expect_end(scan, "the last region");
  pslg.points = std::move(vertices.points);
  pslg.point_markers = std::move(vertices.markers);
  pslg.marker_names = read_marker_notes(poly, syntax.comment);
  pslg.source = source;
  return pslg;
}

std::string format_poly(const Pslg& pslg) {
  std::string text = format_marker_notes(pslg.marker_names, syntax.comment);
  append_vertices(text, pslg.points, {}, pslg.point_markers);
  append_words(text, {std::ssize(pslg.segments), 1});
  end_line(text);
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const auto& [from, to, marker] = pslg.segments[i];
    append_words(text, {static_cast<std::int64_t>(i), static_cast<std::int64_t>(from),
                        static_cast<std::int64_t>(to), marker});
    end_line(text);
  }
  append_words(text, {std::ssize(pslg.holes)});
  end_line(text);
  for (std::size_t i = 0; i < pslg.holes.size(); ++i) {
    append_words(text, {static_cast<std::int64_t>(i)});
    append_point(text, pslg.holes[i]);
    end_line(text);
  }
  append_words(text, {std::ssize(pslg.regions)});
  end_line(text);
  for (std::size_t i = 0; i < pslg.regions.size(); ++i) {
    append_words(text, {static_cast<std::int64_t>(i)});
    append_point(text, pslg.regions[i].seed);
    append_point(text, Point2{pslg.regions[i].attribute, pslg.regions[i].max_area});
    end_line(text);
  }
  return text;
}

MeshSoup<2> triangle_soup(const TriangleFileTexts& texts, const std::string& source) {
  return parse_stem<2>(texts.node, texts.ele, source, [&](const auto& vertices, auto& soup) {
    read_marked_edges(texts, source, vertices, soup);
  });
}

MeshFile parse_triangle_files(const TriangleFileTexts& texts, const std::string& source) {
  return assemble_simplices(triangle_soup(texts, source));
}

MeshFile read_triangle_files(const std::filesystem::path& path) {
  return assemble_simplices(read_triangle_soup(path));
}

MeshSoup<2> read_triangle_soup(const std::filesystem::path& path) {
  const std::filesystem::path ele = sibling(path, ".ele");
  if (path.extension() == ".poly" && !std::filesystem::exists(ele))
    throw InputError(path.string(),
                     "is a geometry without triangles: there is no " + ele.string() + " beside it",
                     "make a mesh of it first (leonhard mesh)");
  TriangleFileTexts texts;
  texts.node = read_whole_file(sibling(path, ".node"));
  texts.ele = read_whole_file(ele);
  texts.poly = text_if_there(sibling(path, ".poly"));
  texts.edge = text_if_there(sibling(path, ".edge"));
  return triangle_soup(texts, sibling(path, "").string());
}

TriangleFileTexts format_triangle_files(const TriangleMesh& mesh) {
  TriangleFileTexts texts;
  append_vertices(texts.node, mesh.points.flat(), {}, mesh.vertex_markers.flat());
  texts.ele = format_marker_notes(mesh.region_names, syntax.comment, "region") +
              format_ele(mesh.corners, mesh.regions);
  texts.poly = format_mesh_poly(mesh);
  texts.neigh = format_neigh(mesh.neighbours);
  return texts;
}

void write_triangle_files(const std::filesystem::path& path, const TriangleMesh& mesh) {
  const TriangleFileTexts texts = format_triangle_files(mesh);
  write_siblings(
      path,
      {{".node", &texts.node}, {".ele", &texts.ele}, {".poly", &*texts.poly}, {".neigh", &*texts.neigh}});
}

}  // namespace leonhard::io
