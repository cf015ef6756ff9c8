// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/kernel/spheres_filter.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// A point of an incremental construction with the notes that the cavity now open keeps at it: which cavity it is, and the
/// vertex' number on its walls. A record of a kernel::SpheresFilter.
struct alignas(kernel::sphere_record_bytes) TetNode {
  Point3 point;
  std::uint32_t notes[2] = {};
};
static_assert(sizeof(TetNode) == kernel::sphere_record_bytes);

/// What an insertion knows of a tetrahedron while its cavity is open. The mark is kept in the top bits of corner 3, since
/// whoever wants to know it will next want the corners; between insertions there are none.
enum class TetMark : unsigned {
  none = 0,     ///< not yet asked
  outside = 1,  ///< asked, and not in conflict
  doomed = 2,   ///< in conflict with the point that is being inserted
};
inline constexpr unsigned tet_mark_shift = 8 * sizeof(IdRaw) - 2;
inline constexpr IdRaw most_nodes = IdRaw{1} << tet_mark_shift;

[[nodiscard]] inline TetMark mark_of(const std::array<VertexId, 4>& corners) {
  return static_cast<TetMark>(corners[3].raw >> tet_mark_shift);
}
[[nodiscard]] inline VertexId unmarked(VertexId corner_3) {
  return VertexId{corner_3.raw & (most_nodes - 1)};
}
/// Mark as outside whoever has not been asked.
inline void mark_if_unasked(std::array<VertexId, 4>& corners) {
  corners[3].raw |= static_cast<IdRaw>(corners[3].raw < most_nodes) << tet_mark_shift;
}
inline void set_mark(std::array<VertexId, 4>& corners, TetMark mark) {
  corners[3].raw = unmarked(corners[3]).raw | static_cast<IdRaw>(mark) << tet_mark_shift;
}

/// What an incremental construction of a tetrahedralisation works on. Several TetInserters may share it: each changes
/// nothing but tetrahedra of vertices that it owns.
struct TetArena {
  std::vector<TetNode> nodes;       ///< one a point, fewer than most_nodes
  GhostTetrahedralization cells;    ///< dead ones among them, whose corners are all the ghost
  std::vector<TetId> free_numbers;  ///< of dead tetrahedra, to be used again

  /// Append dead tetrahedra, without putting them into free_numbers.
  ///
  /// throws  InputError, nothing changed, if ids cannot number that many
  void grow(std::size_t count);
  void kill(TetId t) { cells.corners[t].fill(GhostTetrahedralization::ghost); }
};

}  // namespace leonhard::delaunay
