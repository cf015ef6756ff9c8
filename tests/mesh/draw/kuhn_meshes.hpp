// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/topology.hpp"

/// Tetrahedral meshes for tests of pictures: grids of cubes, six tetrahedra each (H. W. Kuhn's subdivision), of which a
/// part is kept.
namespace leonhard::draw::test {

/// A grid of nx by ny by nz unit cubes; the tetrahedra whose centre is wanted, the vertices then moved. Vertices that no
/// tetrahedron uses are left out.
inline TetMesh kuhn_mesh(
    std::array<std::size_t, 3> n, const std::function<bool(Point3)>& wanted,
    const std::function<Point3(Point3)>& moved = [](Point3 p) { return p; },
    const std::function<Marker(Point3)>& marker_of = [](Point3) { return Marker{1}; }) {
  static constexpr std::array<std::array<std::size_t, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};  // the first three are even
  TetMesh mesh;
  std::map<std::array<std::size_t, 3>, VertexId> number;
  const auto vertex = [&](const std::array<std::size_t, 3>& at) {
    const auto [entry, is_new] = number.try_emplace(at, VertexId::from(number.size()));
    if (is_new) {
      mesh.points.push_back(
          moved({static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])}));
    }
    return entry->second;
  };
  for (std::size_t k = 0; k < n[2]; ++k) {
    for (std::size_t j = 0; j < n[1]; ++j) {
      for (std::size_t i = 0; i < n[0]; ++i) {
        for (std::size_t o = 0; o < 6; ++o) {
          std::array<std::array<std::size_t, 3>, 4> path{{{i, j, k}}};
          Point3 sum{double(i), double(j), double(k)};
          for (std::size_t step = 0; step < 3; ++step) {
            path[step + 1] = path[step];
            ++path[step + 1][orders[o][step]];
            sum = sum + Vec3{double(path[step + 1][0]), double(path[step + 1][1]), double(path[step + 1][2])};
          }
          if (!wanted({sum.x / 4, sum.y / 4, sum.z / 4})) continue;
          if (o >= 3) std::swap(path[2], path[3]);  // positive, as the even ones are
          mesh.corners.push_back({vertex(path[0]), vertex(path[1]), vertex(path[2]), vertex(path[3])});
        }
      }
    }
  }
  TetMesh checked = mesh::make_tet_mesh(std::move(mesh.points), std::move(mesh.corners), {}, {},
                                        "grid of cubes", {.unlisted_boundary = 1});
  for (MarkedFace& face : checked.boundary) {
    const auto corner = [&](std::size_t i) { return checked.points[face.corners[i]]; };
    const Point3 a = corner(0);
    face.marker = marker_of(a + (1.0 / 3) * ((corner(1) - a) + (corner(2) - a)));
  }
  return checked;
}

/// The unit cube, n cubes each way.
inline TetMesh unit_cube(std::size_t n) {
  const double side = static_cast<double>(n);
  return kuhn_mesh(
      {n, n, n}, [](Point3) { return true; },
      [=](Point3 p) {
        return Point3{p.x / side, p.y / side, p.z / side};
      });
}

/// A ball of radius 1 about the origin, from n cubes each way, with a hollow of radius `hollow`. Cubes on concentric
/// shells become spheres; the hollow's boundary has marker 2.
inline TetMesh ball(std::size_t n, double hollow = 0) {
  const double half = static_cast<double>(n) / 2;
  const auto shell = [=](Point3 p) {
    return std::max({std::abs(p.x / half - 1), std::abs(p.y / half - 1), std::abs(p.z / half - 1)});
  };
  const auto to_ball = [=](Point3 p) {
    const Vec3 v{p.x / half - 1, p.y / half - 1, p.z / half - 1};
    const double length = norm(v);
    if (length == 0) return Point3{};
    const double s = shell(p) / length;
    return Point3{s * v.x, s * v.y, s * v.z};
  };
  return kuhn_mesh(
      {n, n, n}, [=](Point3 p) { return shell(p) > hollow; }, to_ball,
      [=](Point3 p) { return norm(p - Point3{}) > (1 + hollow) / 2 ? Marker{1} : Marker{2}; });
}

/// A torus about the z axis, its circles of radius 1 and 0.42, of n layers of cubes across.
inline TetMesh torus(std::size_t n) {
  const double h = 0.84 / static_cast<double>(n);
  const auto across = static_cast<std::size_t>(std::ceil(2.84 / h));
  const double middle = h * static_cast<double>(across) / 2;
  const auto to_space = [=](Point3 p) { return Point3{h * p.x - middle, h * p.y - middle, h * p.z - 0.42}; };
  return kuhn_mesh(
      {across, across, n},
      [=](Point3 p) {
        const Point3 q = to_space(p);
        return std::hypot(std::hypot(q.x, q.y) - 1, q.z) < 0.42;
      },
      to_space, [](Point3 p) { return p.x < 0 ? Marker{1} : Marker{2}; });
}

}  // namespace leonhard::draw::test
