// SPDX-License-Identifier: MIT
#include <filesystem>
#include <utility>

#include "leonhard/mesh/io/formats/surface_formats.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/soup/surface_builder.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

/// The points of the file itself or, where it declares none, of the .node file beside it.
VertexTable<Point3> vertices_of(TextScanner& scan, const std::optional<std::string>& node) {
  VertexTable<Point3> vertices = read_vertices<Point3>(scan);
  if (!vertices.points.empty()) return vertices;
  if (!node)
    scan.fail("the file declares 0 vertices, and there is no .node file beside it",
              "add the .node file of the same name, or the vertices");
  TextScanner node_scan(*node, std::filesystem::path(scan.source()).replace_extension(".node").string(),
                        triangle_syntax);
  vertices = read_vertices<Point3>(node_scan);
  expect_end(node_scan, "the last vertex");
  return vertices;
}

/// The corners of a polygon after their number; they may go on on the next lines.
void read_corners(TextScanner& scan, const VertexTable<Point3>& vertices, SurfaceBuilder& surface) {
  const std::size_t count = scan.count("the number of corners of a polygon", 2);
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_word("a corner of a polygon");
    const std::size_t index = vertices.read_reference(scan, "a corner of a polygon");
    surface.add_corner(static_cast<std::int64_t>(index) + vertices.first_number);
  }
}

/// A facet of a .poly: a line with how many polygons and holes, and the marker; then those, one a line.
void read_facet(TextScanner& scan, const VertexTable<Point3>& vertices, bool with_markers, std::size_t facet,
                SurfaceBuilder& surface) {
  const std::size_t polygons = scan.count("the number of polygons of a facet", 4);
  const std::size_t holes = scan.line_done() ? 0 : scan.count("the number of holes of a facet", 8);
  const Marker marker = with_markers && !scan.line_done() ? scan.integer32("the marker of a facet") : 0;
  scan.expect_line_end("the facet");
  for (std::size_t i = 0; i < polygons; ++i) {
    scan.need_line("a polygon");
    const std::size_t line = scan.line();
    read_corners(scan, vertices, surface);
    scan.expect_line_end("the polygon");
    surface.end_polygon(line, marker, facet);
  }
  for (std::size_t i = 0; i < holes; ++i) {
    scan.need_line("a hole of a facet");
    scan.integer("the number of a hole");
    for (const char* coordinate : {"an x coordinate", "a y coordinate", "a z coordinate"})
      scan.number(coordinate);
    scan.expect_line_end("the hole");
  }
}

SurfaceFile parse(std::string_view text, const std::optional<std::string>& node, const std::string& source,
                  bool one_polygon_a_facet) {
  TextScanner scan(text, source, triangle_syntax);
  VertexTable<Point3> vertices = vertices_of(scan, node);
  SurfaceBuilder surface(source, vertices.first_number);
  scan.need_line("the number of facets");
  const std::size_t count = scan.count("the number of facets", 4);
  const bool with_markers = read_flag(scan, "the number of boundary markers");
  scan.expect_line_end("the header of the facets");
  for (std::size_t i = 0; i < count; ++i) {
    scan.need_line("a facet");
    if (!one_polygon_a_facet) {
      read_facet(scan, vertices, with_markers, i, surface);
      continue;
    }
    const std::size_t line = scan.line();
    read_corners(scan, vertices, surface);
    surface.end_polygon(line, with_markers ? scan.integer32("the marker of a facet") : 0, i);
    scan.expect_line_end("the facet");
  }
  const std::int64_t first_number = vertices.first_number;
  surface.set_points(std::move(static_cast<PointSet3&>(vertices)), first_number);
  return std::move(surface).finish();
}

}  // namespace

SurfaceFile parse_surface_poly(std::string_view poly, const std::optional<std::string>& node,
                               const std::string& source) {
  return parse(poly, node, source, false);
}

SurfaceFile parse_smesh(std::string_view smesh, const std::optional<std::string>& node,
                        const std::string& source) {
  return parse(smesh, node, source, true);
}

}  // namespace leonhard::io
