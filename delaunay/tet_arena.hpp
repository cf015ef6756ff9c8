// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "leonhard/delaunay/ghost_tetrahedralization.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/id.hpp"

namespace leonhard::delaunay {

/// A point of an incremental construction with the notes that the cavity now open keeps at it: 32 bytes, so that all of
/// it lies in one cache line.
struct alignas(32) TetNode {
  Point3 point;
  std::uint32_t cavity = 0;  ///< the cavity that wrote `local`
  std::uint32_t local = 0;   ///< the vertex' number on that cavity's boundary
};

/// What an incremental construction of a tetrahedralisation works on. Several TetInserters may share it: each changes
/// nothing but tetrahedra of vertices that it owns.
struct TetArena {
  enum class Mark : std::uint8_t {
    none,     ///< in the tetrahedralisation, not yet asked
    doomed,   ///< in conflict with the point that is being inserted
    outside,  ///< asked, and not in conflict
    dead,     ///< no tetrahedron has this number
  };

  std::vector<TetNode> nodes;  ///< one a point
  GhostTetrahedralization cells;
  std::vector<Mark> marks;          ///< one a tetrahedron
  std::vector<TetId> free_numbers;  ///< of dead tetrahedra, to be used again

  /// Append dead tetrahedra, without putting them into free_numbers.
  ///
  /// throws  InputError, nothing changed, if ids cannot number that many
  void grow(std::size_t count);
};

}  // namespace leonhard::delaunay
