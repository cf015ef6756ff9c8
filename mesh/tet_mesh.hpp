// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"
#include "leonhard/mesh/pslg.hpp"

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

/// A tetrahedral mesh, any number of components, handles and cavities: the finite-element structure of Barth's notes
/// 1.3 in space, with neighbours. Plain parallel arrays, 32 bytes a tetrahedron; `mesh::validate` says which invariant
/// broke.
///
/// Invariants: corners positive (kernel::orient3d of the four); neighbours[t][i] lies across the face opposite
/// corners[t][i] and points back; every face with a tetrahedron on one side only appears once in `boundary`; every
/// vertex has a tetrahedron.
struct TetMesh {
  PerId<VertexId, Point3> points;
  PerId<TetId, std::array<VertexId, 4>> corners;
  PerId<TetId, std::array<MaybeId<TetId>, 4>> neighbours;

  std::vector<MarkedFace> boundary;    ///< each boundary face once, its normal pointing outwards
  std::vector<MarkedFace> interfaces;  ///< marked faces between two tetrahedra, in either direction

  PerId<VertexId, Marker> vertex_markers;      ///< one a vertex, 0 where none
  PerId<TetId, double> regions;                ///< regional attribute, 0 where none (TetGen's convention)
  std::map<Marker, std::string> marker_names;  ///< e.g. 1 -> "wing"

  [[nodiscard]] std::size_t vertex_count() const { return points.size(); }
  [[nodiscard]] std::size_t tet_count() const { return corners.size(); }

  friend bool operator==(const TetMesh&, const TetMesh&) = default;
};

}  // namespace leonhard
