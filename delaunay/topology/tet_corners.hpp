// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cassert>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"

/// Small questions about the tetrahedra of a GhostTetrahedralization.
namespace leonhard::delaunay {

using TetCorners = std::array<VertexId, 4>;

/// Which corner of t is v: 0 to 3; 4 if none is.
[[nodiscard]] inline unsigned corner_index(const TetCorners& corners, VertexId v) {
  unsigned i = 0;
  while (i < 4 && corners[i] != v) ++i;
  return i;
}
[[nodiscard]] inline bool has_corner(const TetCorners& corners, VertexId v) {
  return corner_index(corners, v) < 4;
}

/// The corners with v in the place of corner i: positive if v lies on the inner side of the face opposite corner i.
[[nodiscard]] inline TetCorners with_corner(TetCorners corners, unsigned i, VertexId v) {
  corners[i] = v;
  return corners;
}

/// The same tetrahedron, equally oriented, with the ghost, if it has one, at corner 0.
[[nodiscard]] inline TetCorners with_ghost_first(TetCorners corners) {
  const unsigned i = corner_index(corners, GhostTetrahedralization::ghost);
  if (i == 4 || i == 0) return corners;
  std::swap(corners[0], corners[i]);
  const unsigned j = i == 1 ? 2 : 1, k = i == 3 ? 2 : 3;
  std::swap(corners[j], corners[k]);
  return corners;
}

/// Which corner of the neighbour behind the face opposite corner i of t lies beyond that face.
[[nodiscard]] inline unsigned mirror_index(const GhostTetrahedralization& in, TetId t, unsigned i) {
  const auto& back = in.neighbours[*in.neighbours[t][i]];
  unsigned k = 0;
  while (k < 3 && back[k] != MaybeId<TetId>(t)) ++k;
  assert(back[k] == MaybeId<TetId>(t));
  return k;
}

/// Call visit(tetrahedron) for every tetrahedron about the edge from a to b, turning once about it; t is one of them
/// and comes first. If visit returns false the turn ends.
///
/// returns  whether the turn was completed
template <class Visit>
bool turn_about_edge(const GhostTetrahedralization& in, TetId t, VertexId a, VertexId b, const Visit& visit) {
  const auto other_than = [&](TetId of, VertexId x) {
    for (const VertexId v : in.corners[of])
      if (v != a && v != b && v != x) return v;
    assert(false);
    return x;
  };
  const TetId first = t;
  VertexId crossed = other_than(t, a);  // the face opposite this corner is crossed next
  do {
    if (!visit(t)) return false;
    const VertexId kept = other_than(t, crossed);
    t = *in.neighbours[t][corner_index(in.corners[t], crossed)];
    crossed = kept;
  } while (t != first);
  return true;
}

}  // namespace leonhard::delaunay
