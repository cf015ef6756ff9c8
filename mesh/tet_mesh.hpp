// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/simplex_mesh.hpp"

namespace leonhard {

/// A triangle between tetrahedra or on the boundary that carries a marker. On the boundary its corners run
/// counter-clockwise as seen from outside, so that its normal points outwards.
struct MarkedFace {
  std::array<VertexId, 3> corners;
  Marker marker{};
  friend bool operator==(const MarkedFace&, const MarkedFace&) = default;
};

/// The corners of a tetrahedron's face opposite corner i, as numbers 0 to 3, counter-clockwise as seen from outside.
inline constexpr std::array<std::array<unsigned, 3>, 4> tet_face_corners{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The six edges of a tetrahedron, as numbers 0 to 3 of its corners; edges i and 5 - i have no corner in common.
inline constexpr std::array<std::array<unsigned, 2>, 6> tet_edge_corners{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

template <>
struct Simplex<3> {
  using Point = Point3;
  using Vector = Vec3;
  using CellId = TetId;
  using FacetId = FaceId;
  using MarkedFacet = MarkedFace;

  struct InnerFacets {
    std::vector<MarkedFace> interfaces;  ///< marked faces between two tetrahedra, in either direction

    [[nodiscard]] std::vector<MarkedFace>& inner_facets() { return interfaces; }
    [[nodiscard]] const std::vector<MarkedFace>& inner_facets() const { return interfaces; }
    friend bool operator==(const InnerFacets&, const InnerFacets&) = default;
  };

  static constexpr const auto& facet_corners = tet_face_corners;

  [[nodiscard]] static const std::array<VertexId, 3>& corners_of(const MarkedFace& face) {
    return face.corners;
  }
  [[nodiscard]] static MarkedFace marked(const std::array<VertexId, 3>& corners, Marker marker) {
    return {corners, marker};
  }

  static constexpr const char *cell = "tetrahedron", *cells = "tetrahedra", *facet = "face";
};

/// A tetrahedral mesh. neighbours[t][i] lies across the face opposite corners[t][i], the normals of `boundary` point
/// outwards; `interfaces` are its inner facets. 32 bytes a tetrahedron.
using TetMesh = SimplexMesh<3>;

}  // namespace leonhard
