// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>

#include "leonhard/mesh/mixed_mesh.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

// Small meshes made in place: triangulated (i, j) grids mapped into the plane.

namespace leonhard::test {

/// Markers of a mapped grid's sides, in the order of the unit square's: low j, high i, high j, low i.
inline constexpr Marker south = 1, east = 2, north = 3, west = 4;

/// (columns x rows) quadrilaterals of the unit square, each cut along alternating diagonals, mapped by `place`, which
/// must keep the orientation. periodic: column 0 is joined to the last (an O-mesh; no east and west sides).
inline TriangleMesh mapped_grid(std::size_t columns, std::size_t rows, bool periodic,
                                const std::function<Point2(double s, double t)>& place) {
  const std::size_t across = periodic ? columns : columns + 1;
  PerId<VertexId, Point2> points;
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i < across; ++i)
      points.push_back(place(static_cast<double>(i) / static_cast<double>(columns),
                             static_cast<double>(j) / static_cast<double>(rows)));
  const auto at = [&](std::size_t i, std::size_t j) { return VertexId::from(j * across + i % across); };
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const VertexId a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if ((i + j) % 2 == 0) {
        corners.push_back({a, b, c});
        corners.push_back({a, c, d});
      } else {
        corners.push_back({a, b, d});
        corners.push_back({b, c, d});
      }
    }
  std::vector<MarkedEdge> boundary;
  for (std::size_t i = 0; i < columns; ++i) {
    boundary.push_back({at(i, 0), at(i + 1, 0), south});
    boundary.push_back({at(i + 1, rows), at(i, rows), north});
  }
  for (std::size_t j = 0; j < rows && !periodic; ++j) {
    boundary.push_back({at(columns, j), at(columns, j + 1), east});
    boundary.push_back({at(0, j + 1), at(0, j), west});
  }
  return mesh::make_triangle_mesh(std::move(points), std::move(corners), std::move(boundary),
                                  {{south, "south"}, {east, "east"}, {north, "north"}, {west, "west"}});
}

/// The quadrilaterals of a mapped grid; whole(i, j) says which stay whole, the others are cut in two.
inline MixedMesh<2> mixed_grid(std::size_t columns, std::size_t rows, const std::function<Point2(double, double)>& place,
                        const std::function<bool(std::size_t, std::size_t)>& whole) {
  const TriangleMesh triangles = mapped_grid(columns, rows, false, place);
  MixedMesh<2> mesh;
  mesh.points = triangles.points;
  mesh.vertex_markers = triangles.vertex_markers;
  for (const MarkedEdge& edge : triangles.boundary) mesh.boundary.push_back({{edge.from, edge.to}, edge.marker});
  const auto at = [&](std::size_t i, std::size_t j) { return VertexId::from(j * (columns + 1) + i); };
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const VertexId v[4] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      if (whole(i, j)) {
        mesh.add_cell(CellKind::quadrilateral, v);
      } else {
        mesh.add_cell(CellKind::triangle, std::array{v[0], v[1], v[2]});
        mesh.add_cell(CellKind::triangle, std::array{v[0], v[2], v[3]});
      }
    }
  return mesh;
}

/// The unit square with inner vertices moved at random by up to `shake` of a cell.
inline TriangleMesh shaken_square(std::size_t cells, double shake, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-shake / static_cast<double>(cells),
                                              shake / static_cast<double>(cells));
  return mapped_grid(cells, cells, false, [&](double s, double t) {
    const bool inside_s = s > 0 && s<1, inside_t = t> 0 && t < 1;
    const double x = move(random), y = move(random);
    return Point2{s + (inside_s ? x : 0), t + (inside_t ? y : 0)};
  });
}

/// NACA 0012 with the sharp trailing edge of the NASA TMR, chord 1. turn in [0, 1): from the trailing edge along the
/// lower side (so that an O-mesh about it is counter-clockwise in (turn, outwards) when mirrored by o_mesh).
inline Point2 naca0012(double turn) {
  const double x = 0.5 * (1 + std::cos(2 * std::numbers::pi * turn));
  const double y = 0.594689181 * (0.298222773 * std::sqrt(x) - 0.127125232 * x - 0.357907906 * x * x +
                                  0.291984971 * x * x * x - 0.105174606 * x * x * x * x);
  return {x, turn < 0.5 ? y : -y};
}

/// An O-mesh between a body (south) and a circle (north) about (0.5, 0); body(turn) runs counter-clockwise.
inline TriangleMesh o_mesh(std::size_t around, std::size_t outwards, double radius, double first_height,
                           const std::function<Point2(double)>& body) {
  // Heights in geometric progression: solve first_height (g^n - 1) / (g - 1) = radius for g by bisection.
  double low = 1 + 1e-9, high = 4;
  for (int i = 0; i < 100; ++i) {
    const double g = 0.5 * (low + high);
    (first_height * (std::pow(g, static_cast<double>(outwards)) - 1) / (g - 1) < radius ? low : high) = g;
  }
  const double g = 0.5 * (low + high), n = static_cast<double>(outwards);
  return mapped_grid(around, outwards, true, [&](double s, double t) {
    // s runs clockwise so that (s, outwards) is right-handed.
    const double turn = s == 0 ? 0 : 1 - s;
    const Point2 from = body(turn);
    const double angle = 2 * std::numbers::pi * turn;
    const Point2 to{0.5 + radius * std::cos(angle), radius * std::sin(angle)};
    const double share = (std::pow(g, t * n) - 1) / (std::pow(g, n) - 1);
    return from + share * (to - from);
  });
}

}  // namespace leonhard::test
