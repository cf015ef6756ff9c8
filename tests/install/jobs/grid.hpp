// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <leonhard/mesh/topology.hpp>
#include <leonhard/mesh/triangle_mesh.hpp>
#include <vector>

/// A mesh as a generator of one's own would make it: columns x rows squares of the unit square, each cut in two, mapped.
/// Markers: 1 south, 2 east, 3 north, 4 west.
inline leonhard::TriangleMesh grid(unsigned columns, unsigned rows,
                                   const std::function<leonhard::Point2(double, double)>& map) {
  using namespace leonhard;
  const auto at = [&](unsigned i, unsigned j) { return VertexId{j * (columns + 1) + i}; };
  PerId<VertexId, Point2> points;
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i <= columns; ++i) points.push_back(map(double(i) / columns, double(j) / rows));
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  for (unsigned j = 0; j < rows; ++j) {
    for (unsigned i = 0; i < columns; ++i) {
      corners.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      corners.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  std::vector<MarkedEdge> boundary;
  for (unsigned i = 0; i < columns; ++i) {
    boundary.push_back({at(i, 0), at(i + 1, 0), 1});
    boundary.push_back({at(i, rows), at(i + 1, rows), 3});
  }
  for (unsigned j = 0; j < rows; ++j) {
    boundary.push_back({at(columns, j), at(columns, j + 1), 2});
    boundary.push_back({at(0, j), at(0, j + 1), 4});
  }
  return mesh::make_triangle_mesh(points, corners, boundary, {{1, "south"}, {2, "east"}, {3, "north"}, {4, "west"}});
}
