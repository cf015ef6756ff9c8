// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/simplex_mesh.hpp"

namespace leonhard {

/// An edge that carries a marker. On the boundary the mesh lies to its left.
struct MarkedEdge {
  VertexId from, to;
  Marker marker{};
  friend bool operator==(const MarkedEdge&, const MarkedEdge&) = default;
};

template <>
struct Simplex<2> {
  using Point = Point2;
  using Vector = Vec2;
  using CellId = TriangleId;
  using FacetId = EdgeId;
  using MarkedFacet = MarkedEdge;

  struct InnerFacets {
    std::vector<MarkedEdge> constraints;  ///< interior edges that came from input segments

    [[nodiscard]] std::vector<MarkedEdge>& inner_facets() { return constraints; }
    [[nodiscard]] const std::vector<MarkedEdge>& inner_facets() const { return constraints; }
    friend bool operator==(const InnerFacets&, const InnerFacets&) = default;
  };

  static constexpr std::array<std::array<unsigned, 2>, 3> facet_corners{{{1, 2}, {2, 0}, {0, 1}}};

  [[nodiscard]] static std::array<VertexId, 2> corners_of(const MarkedEdge& edge) {
    return {edge.from, edge.to};
  }
  [[nodiscard]] static MarkedEdge marked(const std::array<VertexId, 2>& ends, Marker marker) {
    return {ends[0], ends[1], marker};
  }

  static constexpr const char *cell = "triangle", *cells = "triangles", *facet = "edge";
};

/// A triangle mesh of a plane domain. Its corners turn counter-clockwise, neighbours[t][i] lies across the edge opposite
/// corners[t][i], `boundary` has the mesh to its left; `constraints` are its inner facets. 24 bytes a triangle.
using TriangleMesh = SimplexMesh<2>;

}  // namespace leonhard
