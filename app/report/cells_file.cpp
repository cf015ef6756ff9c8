// SPDX-License-Identifier: MIT
#include "leonhard/app/report/cells_file.hpp"

#include <fmt/core.h>

#include <iterator>
#include <string>
#include <vector>

#include "leonhard/app/report/json.hpp"
#include "leonhard/mesh/io/atomic_file.hpp"

namespace leonhard::app {
namespace {

std::vector<VertexId> cells_shown(const delaunay::VoronoiDiagram& diagram,
                                  const delaunay::ClippedVoronoi& cells) {
  std::vector<VertexId> shown;
  for (const VertexId site : diagram.sites.ids())
    if (!cells.cell(site).empty()) shown.push_back(site);
  return shown;
}

/// One array of text in a .vtu file: what `value` appends for each cell.
template <class Value>
void append_array(std::string& text, const char* head, const std::vector<VertexId>& shown, Value value) {
  text += std::string("<DataArray ") + head + " format=\"ascii\">\n";
  for (const VertexId site : shown) value(site);
  text += "</DataArray>\n";
}

}  // namespace

void write_cells_vtu(const std::filesystem::path& path, const delaunay::VoronoiDiagram& diagram,
                     const delaunay::ClippedVoronoi& cells) {
  constexpr int vtk_polygon = 7;
  const std::vector<VertexId> shown = cells_shown(diagram, cells);
  std::string text;
  const auto add = std::back_inserter(text);
  const auto array = [&](const char* head, auto value) { append_array(text, head, shown, value); };
  text +=
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n";
  fmt::format_to(add, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<CellData>\n",
                 cells.corners.size(), shown.size());
  array("type=\"Int64\" Name=\"site\"", [&](VertexId site) { fmt::format_to(add, "{}\n", site.index()); });
  array("type=\"Float64\" Name=\"area\"",
        [&](VertexId site) { fmt::format_to(add, "{}\n", cells.area[site]); });
  array("type=\"UInt8\" Name=\"unbounded\"",
        [&](VertexId site) { fmt::format_to(add, "{}\n", diagram.is_unbounded(site) ? 1 : 0); });
  text += "</CellData>\n<Points>\n";
  array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", [&](VertexId site) {
    for (const Point2 p : cells.cell(site)) fmt::format_to(add, "{} {} 0\n", p.x, p.y);
  });
  text += "</Points>\n<Cells>\n";
  std::size_t corners = 0, offset = 0;
  array("type=\"Int64\" Name=\"connectivity\"", [&](VertexId site) {
    for (std::size_t i = 0; i < cells.cell(site).size(); ++i) fmt::format_to(add, "{} ", corners++);
    text += '\n';
  });
  array("type=\"Int64\" Name=\"offsets\"",
        [&](VertexId site) { fmt::format_to(add, "{}\n", offset += cells.cell(site).size()); });
  array("type=\"UInt8\" Name=\"types\"", [&](VertexId) { fmt::format_to(add, "{}\n", vtk_polygon); });
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  io::write_file_atomically(path, text);
}

void write_cells_json(const std::filesystem::path& path, const delaunay::VoronoiDiagram& diagram,
                      const delaunay::ClippedVoronoi& cells) {
  std::string text = "{\"cells\":[";
  for (const VertexId site : cells_shown(diagram, cells)) {
    Json corners = Json::array();
    for (const Point2 p : cells.cell(site)) corners.push_back(Json::array({p.x, p.y}));
    const Json cell{{"site", site.index()},
                    {"at", Json::array({diagram.sites[site].x, diagram.sites[site].y})},
                    {"area", cells.area[site]},
                    {"unbounded", diagram.is_unbounded(site)},
                    {"corners", corners}};
    if (text.back() != '[') text += ',';
    text += cell.line();
  }
  text += "],\"site_of_input\":[";
  for (std::size_t i = 0; i < diagram.site_of_input.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{}{}", i == 0 ? "" : ",", diagram.site_of_input[i].index());
  io::write_file_atomically(path, text + "]}\n");
}

void write_cells_geojson(const std::filesystem::path& path, const delaunay::VoronoiDiagram& diagram,
                         const delaunay::ClippedVoronoi& cells) {
  std::string text = "{\"type\":\"FeatureCollection\",\"features\":[";
  for (const VertexId site : cells_shown(diagram, cells)) {
    Json ring = Json::array();
    for (const Point2 p : cells.cell(site)) ring.push_back(Json::array({p.x, p.y}));
    const Point2 first = cells.cell(site).front();
    ring.push_back(Json::array({first.x, first.y}));
    const Json feature{{"type", "Feature"},
                       {"properties", Json{{"site", site.index()},
                                           {"x", diagram.sites[site].x},
                                           {"y", diagram.sites[site].y},
                                           {"area", cells.area[site]},
                                           {"unbounded", diagram.is_unbounded(site)}}},
                       {"geometry", Json{{"type", "Polygon"}, {"coordinates", Json::array({ring})}}}};
    if (text.back() != '[') text += ',';
    text += feature.line();
  }
  io::write_file_atomically(path, text + "]}\n");
}

}  // namespace leonhard::app
