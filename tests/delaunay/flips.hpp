// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include "leonhard/delaunay/algorithm.hpp"
#include "leonhard/delaunay/topology/interior_edges.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/topology.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

/// Other triangulations of the same points.
namespace leonhard::shapes {

/// The pairs of triangles whose diagonal can be exchanged; constraints stay.
inline std::vector<delaunay::TrianglePair> convex_pairs(const TriangleMesh& mesh) {
  std::vector<delaunay::TrianglePair> pairs;
  (void)delaunay::first_of_interior_edges(
      mesh, [&](const delaunay::TrianglePair& pair) -> std::optional<int> {
        const Point2 left = mesh.points[pair.left], right = mesh.points[pair.right];
        if (kernel::orient2d(right, left, mesh.points[pair.from]) == Sign::positive &&
            kernel::orient2d(left, right, mesh.points[pair.to]) == Sign::positive)
          pairs.push_back(pair);
        return std::nullopt;
      });
  return pairs;
}

/// The mesh with the other diagonal of two of its triangles.
inline TriangleMesh flipped(const TriangleMesh& mesh, const delaunay::TrianglePair& pair) {
  TriangleMesh other = mesh;
  other.corners[pair.left_triangle] = {pair.right, pair.left, pair.from};
  other.corners[pair.right_triangle] = {pair.left, pair.right, pair.to};
  mesh::build_neighbours(other);
  return other;
}

/// Another triangulation of the same points, far from Delaunay.
inline TriangleMesh scrambled(TriangleMesh mesh, unsigned seed, int flips) {
  std::mt19937 random(seed);
  for (int i = 0; i < flips; ++i) {
    const auto pairs = convex_pairs(mesh);
    if (pairs.empty()) break;
    mesh = flipped(mesh, pairs[random() % pairs.size()]);
  }
  return mesh;
}

inline std::vector<double> random_values(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(value(random));
  return values;
}

/// The triangulation of all points as a mesh; outer edges are its boundary.
inline TriangleMesh mesh_of(const delaunay::GhostTriangulation& in, const std::vector<Point2>& points) {
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  std::vector<MarkedEdge> boundary;
  for (const delaunay::AnyTriangleId t : in.triangles()) {
    if (in.is_ghost(t))
      boundary.push_back({in.corner(t, 2), in.corner(t, 1), 1});
    else
      corners.push_back({in.corner(t, 0), in.corner(t, 1), in.corner(t, 2)});
  }
  return mesh::make_triangle_mesh(PerId<VertexId, Point2>(points), corners, boundary);
}

}  // namespace leonhard::shapes
