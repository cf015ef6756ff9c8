// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/points3_file.hpp"

#include <algorithm>
#include <utility>

#include "leonhard/mesh/io/atomic_file.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/formats/triangle_tables.hpp"
#include "leonhard/mesh/io/number_text.hpp"
#include "leonhard/mesh/io/surface_file.hpp"
#include "leonhard/mesh/io/text/point_columns.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::io {

namespace {

/// Files of points alone, which can be written too.
const std::vector<std::string>& own_extensions() {
  static const std::vector<std::string> known{".node", ".xyz", ".xy", ".csv", ".txt"};
  return known;
}

}  // namespace

const std::vector<std::string>& point3_extensions() {
  static const std::vector<std::string> known = [] {
    std::vector<std::string> all = own_extensions();
    all.insert(all.end(), surface_extensions().begin(), surface_extensions().end());
    return all;
  }();
  return known;
}

Points3File parse_node3(std::string_view text, const std::string& source) {
  TextScanner scan(text, source, triangle_syntax);
  VertexTable<Point3> table = read_vertices<Point3>(scan);
  expect_end(scan, "the last vertex");
  if (table.points.empty()) scan.fail("the file declares 0 vertices", "give at least one point");
  return {std::move(static_cast<PointSet3&>(table)), {}};
}

Points3File parse_xyz(std::string_view text, const std::string& source) {
  PointColumns columns = parse_point_columns(text, source, 3, true);
  Points3File file;
  file.warnings = std::move(columns.warnings);
  file.set.points.reserve(columns.coordinates.size() / 3);
  for (std::size_t i = 0; i < columns.coordinates.size(); i += 3)
    file.set.points.push_back(
        {columns.coordinates[i], columns.coordinates[i + 1], columns.coordinates[i + 2]});
  return file;
}

Points3File read_points3(const std::filesystem::path& path) {
  const std::string extension = known_extension(path, point3_extensions(), "points");
  if (extension == ".node") return parse_node3(read_whole_file(path), path.string());
  if (std::find(own_extensions().begin(), own_extensions().end(), extension) != own_extensions().end())
    return parse_xyz(read_whole_file(path), path.string());
  SurfaceFile surface = read_surface(path);
  return {std::move(surface.set), std::move(surface.warnings)};
}

std::string format_node3(const PointSet3& set) {
  std::string text;
  append_vertices(text, set.points, set.attributes, set.markers);
  return text;
}

std::string format_xyz(const PointSet3& set, char separator) {
  std::string text;
  for (const Point3& p : set.points) {
    append_number(text, p.x);
    text += separator;
    append_number(text, p.y);
    text += separator;
    append_number(text, p.z);
    text += '\n';
  }
  return text;
}

void write_points3(const std::filesystem::path& path, const PointSet3& set) {
  const std::string extension = known_extension(path, own_extensions(), "points");
  write_file_atomically(
      path, extension == ".node" ? format_node3(set) : format_xyz(set, extension == ".csv" ? ',' : ' '));
}

}  // namespace leonhard::io
