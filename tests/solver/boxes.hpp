// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "leonhard/mesh/mixed_mesh.hpp"

// Meshes of the unit cube, moved by a map.

namespace leonhard::test {

/// Markers of the cube's sides: x = 0 and 1, y = 0 and 1, z = 0 and 1.
enum BoxSide : Marker { low_x = 1, high_x, low_y, high_y, low_z, high_z };

enum class BoxCells { tetrahedra, hexahedra, prisms };

/// A grid of cells[0] x cells[1] x cells[2] boxes: whole, two prisms each, or six tetrahedra each (H. W. Kuhn's).
/// place  where the point (s, t, u) of the cube goes; must keep the cells positive
inline MixedMesh<3> box_grid(std::array<std::size_t, 3> cells, BoxCells kind,
                             const std::function<Point3(double, double, double)>& place) {
  MixedMesh<3> mesh;
  const auto at = [&](std::array<std::size_t, 3> i) {
    return VertexId::from((i[2] * (cells[1] + 1) + i[1]) * (cells[0] + 1) + i[0]);
  };
  const auto part = [&](std::size_t i, std::size_t axis) {
    return static_cast<double>(i) / static_cast<double>(cells[axis]);
  };
  for (std::size_t k = 0; k <= cells[2]; ++k)
    for (std::size_t j = 0; j <= cells[1]; ++j)
      for (std::size_t i = 0; i <= cells[0]; ++i) mesh.points.push_back(place(part(i, 0), part(j, 1), part(k, 2)));
  mesh.vertex_markers.resize(mesh.points.size());

  const auto corner = [&](std::array<std::size_t, 3> from, int di, int dj, int dk) {
    return at({from[0] + static_cast<std::size_t>(di), from[1] + static_cast<std::size_t>(dj),
               from[2] + static_cast<std::size_t>(dk)});
  };
  const auto add_tetrahedra = [&](std::array<std::size_t, 3> from) {
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
      std::array<std::size_t, 3> way = from;
      std::array<VertexId, 4> v{at(from)};
      for (std::size_t step = 0; step < 3; ++step) ++way[axes[step]], v[step + 1] = at(way);
      const bool even = (axes[0] + 1) % 3 == axes[1];
      if (!even) std::swap(v[1], v[2]);
      mesh.add_cell(CellKind::tetrahedron, v);
    } while (std::next_permutation(axes.begin(), axes.end()));
  };
  const auto add_box = [&](std::array<std::size_t, 3> f) {
    const VertexId a = corner(f, 0, 0, 0), b = corner(f, 1, 0, 0), c = corner(f, 1, 1, 0), d = corner(f, 0, 1, 0),
                   e = corner(f, 0, 0, 1), g = corner(f, 1, 0, 1), h = corner(f, 1, 1, 1), i = corner(f, 0, 1, 1);
    if (kind == BoxCells::hexahedra) {
      mesh.add_cell(CellKind::hexahedron, std::array{a, b, c, d, e, g, h, i});
    } else if (kind == BoxCells::prisms) {
      mesh.add_cell(CellKind::prism, std::array{a, b, c, e, g, h});
      mesh.add_cell(CellKind::prism, std::array{a, c, d, e, h, i});
    } else {
      add_tetrahedra(f);
    }
  };
  for (std::size_t k = 0; k < cells[2]; ++k)
    for (std::size_t j = 0; j < cells[1]; ++j)
      for (std::size_t i = 0; i < cells[0]; ++i) add_box({i, j, k});

  // Each side's quadrilaterals, outwards, a the corner of least coordinates and c the opposite one: on both the diagonal of Kuhn.
  const auto add_side = [&](std::size_t normal, bool high) {
    const std::size_t first = (normal + 1) % 3, second = (normal + 2) % 3;
    const bool triangles = kind == BoxCells::tetrahedra || (kind == BoxCells::prisms && normal == 2);
    for (std::size_t j = 0; j < cells[second]; ++j)
      for (std::size_t i = 0; i < cells[first]; ++i) {
        std::array<std::size_t, 3> low{};
        low[normal] = high ? cells[normal] : 0, low[first] = i, low[second] = j;
        std::array<std::size_t, 3> right = low, opposite = low, up = low;
        ++right[first], ++opposite[first], ++opposite[second], ++up[second];
        VertexId a = at(low), b = at(right), c = at(opposite), d = at(up);
        if (!high) std::swap(b, d);
        const auto marker = static_cast<Marker>(2 * normal + (high ? 2 : 1));
        if (triangles) {
          mesh.boundary.push_back({{a, b, c}, marker});
          mesh.boundary.push_back({{a, c, d}, marker});
        } else {
          mesh.boundary.push_back({{a, b, c, d}, marker});
        }
      }
  };
  for (std::size_t normal = 0; normal < 3; ++normal)
    for (const bool high : {false, true}) add_side(normal, high);
  return mesh;
}

/// The cube with inner points moved about, the same way for the same place. Sides stay flat.
inline Point3 shaken_cube(double s, double t, double u, double size) {
  const auto inside = [](double x) { return x > 0 && x < 1 ? 1.0 : 0.0; };
  return {s + size * inside(s) * std::sin(97 * s + 31 * t + 59 * u), t + size * inside(t) * std::cos(53 * s - 71 * t + 37 * u),
          u + size * inside(u) * std::sin(41 * s + 67 * t - 83 * u)};
}

}  // namespace leonhard::test
