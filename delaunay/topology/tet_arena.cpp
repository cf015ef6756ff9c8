// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/topology/tet_arena.hpp"

#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::delaunay {

void TetArena::grow(std::size_t count) {
  const std::size_t needed = cells.tet_count() + count, most = GhostTetrahedralization::ghost.index();
  if (needed > most)
    throw InputError("points",
                     "their tetrahedralisation has more than " + std::to_string(most) +
                         " tetrahedra, which ids of " + std::to_string(8 * sizeof(IdRaw)) +
                         " bits cannot number",
                     "build with -DLEONHARD_64BIT_IDS=ON or leave points out");
  constexpr VertexId ghost = GhostTetrahedralization::ghost;
  cells.corners.resize(needed, {ghost, ghost, ghost, ghost});
  cells.neighbours.resize(needed);
}

}  // namespace leonhard::delaunay
