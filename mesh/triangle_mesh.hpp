// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"

namespace leonhard {

/// An edge that carries a marker. On the boundary the mesh lies to its left.
struct MarkedEdge {
  VertexId from, to;
  Marker marker{};
  friend bool operator==(const MarkedEdge&, const MarkedEdge&) = default;
};

/// A triangle mesh of a plane domain, any number of components and holes: the finite-element structure of
/// Barth's notes 1.3, with neighbours. Plain parallel arrays; `mesh::validate` says which invariant broke.
///
/// Invariants: corners counter-clockwise (orient2d positive); neighbours[t][i] lies across the edge opposite
/// corners[t][i] and points back; every edge with a triangle on one side only appears once in `boundary`;
/// every vertex has a triangle.
struct TriangleMesh {
  PerId<VertexId, Point2> points;
  PerId<TriangleId, std::array<VertexId, 3>> corners;
  PerId<TriangleId, std::array<MaybeId<TriangleId>, 3>> neighbours;

  std::vector<MarkedEdge> boundary;     ///< each boundary edge once, the mesh to its left
  std::vector<MarkedEdge> constraints;  ///< interior edges that came from input segments

  PerId<VertexId, Marker> vertex_markers;      ///< one a vertex, 0 where none
  PerId<TriangleId, double> regions;           ///< regional attribute, 0 where none (Triangle's convention)
  std::map<Marker, std::string> marker_names;  ///< e.g. 1 -> "airfoil"

  [[nodiscard]] std::size_t vertex_count() const { return points.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return corners.size(); }
};

}  // namespace leonhard
