// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// A tetrahedralisation of the 3-sphere as pure combinatorics: no coordinates. One vertex is the ghost: it stands for
/// all that lies outside, so that every face has a tetrahedron behind it. A ghost tetrahedron (ghost, a, b, c) lies
/// behind the hull's face a, b, c; its corner 0 is the ghost, and it is positive if the ghost is thought of as a point
/// beyond that face: kernel::orient3d(p, a, b, c) is positive for all p beyond it.
///
/// Ghosts and real tetrahedra are numbered by TetId alike: a mesh takes the arrays of the real ones over as they are.
///
/// 32 bytes a tetrahedron: four corners, positive, and four neighbours, neighbours[t][i] across the face opposite
/// corners[t][i], none of which is missing.
struct GhostTetrahedralization {
  static constexpr VertexId ghost{std::numeric_limits<IdRaw>::max() - 1};

  PerId<TetId, std::array<VertexId, 4>> corners;
  PerId<TetId, std::array<MaybeId<TetId>, 4>> neighbours;

  [[nodiscard]] std::size_t tet_count() const { return corners.size(); }
  [[nodiscard]] bool is_ghost(TetId t) const { return corners[t][0] == ghost; }

  /// Take away tetrahedra, which none of the others has for a neighbour. The last ones take their numbers.
  void erase(std::vector<TetId> dead);

  /// The first broken invariant in words: neighbours that do not point back or do not share three corners in opposite
  /// order, a repeated corner, a ghost elsewhere than at corner 0. Cost O(tetrahedra).
  [[nodiscard]] std::optional<std::string> validate() const;
};

}  // namespace leonhard::delaunay
