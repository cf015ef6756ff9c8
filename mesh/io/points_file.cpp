// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/points_file.hpp"

#include <utility>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/number_text.hpp"
#include "leonhard/mesh/io/text/point_columns.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

const std::vector<std::string>& point_extensions() {
  static const std::vector<std::string> known{".node", ".xy", ".xyz", ".csv", ".txt"};
  return known;
}

PointsFile parse_node(std::string_view text, const std::string& source) {
  TextScanner scan(text, source, triangle_syntax);
  VertexTable<Point2> table = read_vertices<Point2>(scan);
  expect_end(scan, "the last vertex");
  if (table.points.empty()) scan.fail("the file declares 0 vertices", "give at least one point");
  return {std::move(static_cast<PointSet&>(table)), {}};
}

PointsFile parse_xy(std::string_view text, const std::string& source, bool further) {
  PointColumns columns = parse_point_columns(text, source, 2, further);
  PointsFile file;
  file.warnings = std::move(columns.warnings);
  file.set.points.reserve(columns.coordinates.size() / 2);
  for (std::size_t i = 0; i < columns.coordinates.size(); i += 2)
    file.set.points.push_back({columns.coordinates[i], columns.coordinates[i + 1]});
  return file;
}

PointsFile read_points(const std::filesystem::path& path) {
  const std::string extension = known_extension(path, point_extensions(), "points");
  const std::string text = read_whole_file(path);
  return extension == ".node" ? parse_node(text, path.string())
                              : parse_xy(text, path.string(), extension == ".xy");
}

std::string format_node(const PointSet& set) {
  std::string text;
  append_vertices(text, set.points, set.attributes, set.markers);
  return text;
}

std::string format_xy(const PointSet& set, char separator) {
  std::string text;
  for (const Point2 p : set.points) {
    append_number(text, p.x);
    text += separator;
    append_number(text, p.y);
    text += '\n';
  }
  return text;
}

void write_points(const std::filesystem::path& path, const PointSet& set) {
  static const std::vector<std::string> known{".node", ".xy", ".csv", ".txt"};
  const std::string extension = known_extension(path, known, "points");
  write_file_atomically(
      path, extension == ".node" ? format_node(set) : format_xy(set, extension == ".csv" ? ',' : ' '));
}

}  // namespace leonhard::io
