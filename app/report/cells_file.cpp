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

/// One array of text in a .vtu file: what `value` appends for each piece, by its number.
template <class Value>
void append_array(std::string& text, const char* head, std::size_t pieces, Value value) {
  text += std::string("<DataArray ") + head + " format=\"ascii\">\n";
  for (std::size_t i = 0; i < pieces; ++i) value(i);
  text += "</DataArray>\n";
}

}  // namespace

void write_cells_vtu(const std::filesystem::path& path, const delaunay::VoronoiDiagram& diagram,
                     const delaunay::VoronoiPieces& pieces) {
  constexpr int vtk_polygon = 7;
  std::string text;
  const auto add = std::back_inserter(text);
  const auto array = [&](const char* head, auto value) { append_array(text, head, pieces.size(), value); };
  text +=
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n";
  fmt::format_to(add, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<CellData>\n",
                 pieces.corners.size(), pieces.size());
  array("type=\"Int64\" Name=\"site\"",
        [&](std::size_t i) { fmt::format_to(add, "{}\n", pieces.site[i].index()); });
  array("type=\"Float64\" Name=\"area\"",
        [&](std::size_t i) { fmt::format_to(add, "{}\n", pieces.area[i]); });
  array("type=\"UInt8\" Name=\"unbounded\"",
        [&](std::size_t i) { fmt::format_to(add, "{}\n", diagram.is_unbounded(pieces.site[i]) ? 1 : 0); });
  text += "</CellData>\n<Points>\n";
  array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", [&](std::size_t i) {
    for (const Point2 p : pieces.piece(i)) fmt::format_to(add, "{} {} 0\n", p.x, p.y);
  });
  text += "</Points>\n<Cells>\n";
  std::size_t corners = 0, offset = 0;
  array("type=\"Int64\" Name=\"connectivity\"", [&](std::size_t i) {
    for (std::size_t k = 0; k < pieces.piece(i).size(); ++k) fmt::format_to(add, "{} ", corners++);
    text += '\n';
  });
  array("type=\"Int64\" Name=\"offsets\"",
        [&](std::size_t i) { fmt::format_to(add, "{}\n", offset += pieces.piece(i).size()); });
  array("type=\"UInt8\" Name=\"types\"", [&](std::size_t) { fmt::format_to(add, "{}\n", vtk_polygon); });
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  io::write_file_atomically(path, text);
}

void write_cells_json(const std::filesystem::path& path, const delaunay::VoronoiDiagram& diagram,
                      const delaunay::VoronoiPieces& pieces) {
  std::string text = "{\"cells\":[";
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const VertexId site = pieces.site[i];
    Json corners = Json::array();
    for (const Point2 p : pieces.piece(i)) corners.push_back(Json::array({p.x, p.y}));
    const Json cell{{"site", site.index()},
                    {"at", Json::array({diagram.sites[site].x, diagram.sites[site].y})},
                    {"area", pieces.area[i]},
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
                         const delaunay::VoronoiPieces& pieces) {
  std::string text = "{\"type\":\"FeatureCollection\",\"features\":[";
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const VertexId site = pieces.site[i];
    Json ring = Json::array();
    for (const Point2 p : pieces.piece(i)) ring.push_back(Json::array({p.x, p.y}));
    const Point2 first = pieces.piece(i).front();
    ring.push_back(Json::array({first.x, first.y}));
    const Json feature{{"type", "Feature"},
                       {"properties", Json{{"site", site.index()},
                                           {"x", diagram.sites[site].x},
                                           {"y", diagram.sites[site].y},
                                           {"area", pieces.area[i]},
                                           {"unbounded", diagram.is_unbounded(site)}}},
                       {"geometry", Json{{"type", "Polygon"}, {"coordinates", Json::array({ring})}}}};
    if (text.back() != '[') text += ',';
    text += feature.line();
  }
  io::write_file_atomically(path, text + "]}\n");
}

}  // namespace leonhard::app
