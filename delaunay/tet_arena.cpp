// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/tet_arena.hpp"

#include <string>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard::delaunay {

void TetArena::grow(std::size_t count) {
  const std::size_t needed = marks.size() + count, most = GhostTetrahedralization::ghost.index();
  if (needed > most)
    throw InputError("points",
                     "their tetrahedralisation has more than " + std::to_string(most) + " tetrahedra, which ids of " +
                         std::to_string(8 * sizeof(IdRaw)) + " bits cannot number",
                     "build with -DLEONHARD_64BIT_IDS=ON or leave points out");
  cells.corners.resize(needed);
  cells.neighbours.resize(needed);
  marks.resize(needed, Mark::dead);
}

}  // namespace leonhard::delaunay
