// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/delaunay/topology/tet_conflict.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/predicates3.hpp"
#include "leonhard/kernel/stages/exact.hpp"

/// What tetrahedralisations are tested against.
namespace leonhard::oracles {

using TetPoints = std::array<Point3, 4>;  ///< in lexicographic order

/// A set of tetrahedra as coordinates alone, sorted: equal for equal sets.
inline std::vector<TetPoints> sorted_tets(std::vector<TetPoints> tets) {
  for (TetPoints& t : tets) std::sort(t.begin(), t.end());
  std::sort(tets.begin(), tets.end());
  return tets;
}

/// The real tetrahedra.
inline std::vector<TetPoints> tet_set(const delaunay::GhostTetrahedralization& cells,
                                      std::span<const Point3> points) {
  std::vector<TetPoints> tets;
  for (const TetId t : cells.corners.ids()) {
    if (cells.is_ghost(t)) continue;
    const auto& [a, b, c, d] = cells.corners[t];
    tets.push_back({points[a.index()], points[b.index()], points[c.index()], points[d.index()]});
  }
  return sorted_tets(std::move(tets));
}

/// The Delaunay tetrahedralisation from its definition: all quadruples that no other point is in the sphere of, ties
/// broken. O(n^5), for some 20 distinct points.
inline std::vector<TetPoints> brute_force_tets(std::span<const Point3> points) {
  std::vector<TetPoints> tets;
  const std::size_t n = points.size();
  const auto is_empty = [&](const TetPoints& t) {
    return std::none_of(points.begin(), points.end(), [&](const Point3& p) {
      return kernel::insphere_perturbed(t[0], t[1], t[2], t[3], p) == Sign::positive;
    });
  };
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c)
        for (std::size_t d = c + 1; d < n; ++d) {
          TetPoints t{points[a], points[b], points[c], points[d]};
          const Sign sign = kernel::orient3d(t[0], t[1], t[2], t[3]);
          if (sign == Sign::negative) std::swap(t[0], t[1]);
          if (sign != Sign::zero && is_empty(t)) tets.push_back(t);
        }
  return sorted_tets(std::move(tets));
}

/// Six times the volume of a positive tetrahedron.
inline mpq_class volume6(const TetPoints& t) {
  std::array<std::array<mpq_class, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    m[i][0] = mpq_class(t[i + 1].x) - mpq_class(t[0].x);
    m[i][1] = mpq_class(t[i + 1].y) - mpq_class(t[0].y);
    m[i][2] = mpq_class(t[i + 1].z) - mpq_class(t[0].z);
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// What is wrong with a tetrahedralisation of the sphere as a Delaunay one: real tetrahedra positive, no point beyond a
/// face in the sphere behind it, ghosts and ties included; every point a corner. With the topology of
/// GhostTetrahedralization::validate that makes it the Delaunay one.
inline std::optional<std::string> broken_geometry(const delaunay::GhostTetrahedralization& cells,
                                                  std::span<const Point3> points) {
  std::vector<bool> used(points.size(), false);
  for (const TetId t : cells.corners.ids()) {
    const auto name = "tetrahedron " + std::to_string(t.raw);
    const auto& c = cells.corners[t];
    for (const VertexId v : c)
      if (v != delaunay::GhostTetrahedralization::ghost) used[v.index()] = true;
    if (!cells.is_ghost(t) && kernel::orient3d(points[c[0].index()], points[c[1].index()],
                                               points[c[2].index()], points[c[3].index()]) != Sign::positive)
      return name + " is not positive";
    for (unsigned i = 0; i < 4; ++i) {
      const TetId n = *cells.neighbours[t][i];
      const VertexId beyond = cells.corners[n][delaunay::mirror_index(cells, t, i)];
      if (beyond != delaunay::GhostTetrahedralization::ghost &&
          delaunay::in_conflict(cells, points, t, points[beyond.index()]))
        return name + " has vertex " + std::to_string(beyond.raw) + " in its sphere";
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) return "point " + std::to_string(i) + " is no corner";
  return std::nullopt;
}

}  // namespace leonhard::oracles
