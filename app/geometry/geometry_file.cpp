// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/geometry_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "leonhard/app/geometry/hole_seeds.hpp"
#include "leonhard/app/geometry/outline_checks.hpp"
#include "leonhard/app/points/planar_shapes.hpp"
#include "leonhard/app/points/points_json.hpp"
#include "leonhard/app/points/read_any_points.hpp"
#include "leonhard/mesh/io/airfoil_dat.hpp"
#include "leonhard/mesh/io/extension.hpp"
#include "leonhard/mesh/io/pslg_file.hpp"
#include "leonhard/mesh/io/text_scanner.hpp"

namespace leonhard::app {
namespace {

constexpr Marker marker_of_lines = 1;

void add_segments(Pslg& pslg, std::size_t first, std::size_t end, bool closed,
                  Marker marker = marker_of_lines) {
  for (std::size_t i = first; i + 1 < end; ++i) pslg.segments.push_back({i, i + 1, marker});
  if (closed && end > first + 2) pslg.segments.push_back({end - 1, first, marker});
}

GeometryFile geometry_of(PlanarShapes&& shapes, const std::string& source) {
  GeometryFile file;
  file.warnings = std::move(shapes.points.warnings);
  file.pslg.source = source;
  file.pslg.points = std::move(shapes.points.set.points);
  for (const PlanarShapes::Line& line : shapes.lines) {
    add_segments(file.pslg, line.first, line.end, line.closed);
    if (!line.hole) continue;
    const auto begin = file.pslg.points.begin();
    NamedOutline hole{
        fmt::format("hole {}", file.pslg.holes.size() + 1),
        source,
        {begin + static_cast<std::ptrdiff_t>(line.first), begin + static_cast<std::ptrdiff_t>(line.end)}};
    check_outline(hole);
    file.pslg.holes.push_back(point_inside(hole));
  }
  return file;
}

/// Sections of an airfoil file, each an outline with its number as marker; they lie beside each other.
GeometryFile geometry_of_airfoils(const std::filesystem::path& path) {
  GeometryFile file;
  file.pslg.source = path.string();
  for (AirfoilCoordinates& element : io::read_airfoils(path)) {
    const std::size_t first = file.pslg.points.size();
    const auto marker = static_cast<Marker>(file.pslg.marker_names.size() + 1);
    file.pslg.points.insert(file.pslg.points.end(), element.points.begin(), element.points.end());
    add_segments(file.pslg, first, file.pslg.points.size(), true, marker);
    file.pslg.marker_names.emplace(marker, path.stem().string() + "_" + std::to_string(marker));
    std::move(element.warnings.begin(), element.warnings.end(), std::back_inserter(file.warnings));
  }
  return file;
}

GeometryFile geometry_of_points(const std::filesystem::path& path) {
  PointsFile points = read_any_points(path);
  GeometryFile file;
  file.warnings = std::move(points.warnings);
  if (points.set.attributes_each > 0)
    file.warnings.push_back(path.string() + ": the attributes of its points are not carried to the mesh");
  file.pslg.source = path.string();
  file.pslg.points = std::move(points.set.points);
  file.pslg.point_markers = std::move(points.set.markers);
  return file;
}

}  // namespace

const std::vector<std::string>& any_geometry_extensions() {
  static const std::vector<std::string> known = [] {
    std::vector<std::string> all = io::pslg_extensions();
    all.insert(all.end(), {".wkt", ".dat"});
    all.insert(all.end(), any_point_extensions().begin(), any_point_extensions().end());
    return all;
  }();
  return known;
}

GeometryFile read_any_geometry(const std::filesystem::path& path) {
  const std::string extension = io::known_extension(path, any_geometry_extensions(), "points or geometry");
  if (extension == ".poly") {
    GeometryFile file;
    file.pslg = io::read_pslg(path, file.warnings);
    return file;
  }
  if (std::ranges::count(io::pslg_extensions(), extension) > 0) {
    io::EdgeGraphFile edges = io::read_edge_graph(path);
    find_holes(edges.pslg, edges.outline_segments, edges.warnings);
    return {std::move(edges.pslg), std::move(edges.warnings)};
  }
  if (extension == ".dat") return geometry_of_airfoils(path);
  if (extension == ".wkt")
    return geometry_of(parse_wkt(io::read_whole_file(path), path.string()), path.string());
  if (extension == ".json" || extension == ".geojson")
    return geometry_of(parse_shapes_json(io::read_whole_file(path), path.string()), path.string());
  return geometry_of_points(path);
}

GeometryFile as_outline(GeometryFile file) {
  Pslg& pslg = file.pslg;
  if (pslg.points.size() > 1 && pslg.points.back() == pslg.points.front()) {
    pslg.points.pop_back();
    if (!pslg.point_markers.empty()) pslg.point_markers.pop_back();
  }
  add_segments(pslg, 0, pslg.points.size(), true);
  return file;
}

}  // namespace leonhard::app
