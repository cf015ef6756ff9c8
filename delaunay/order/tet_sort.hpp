// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "leonhard/delaunay/topology/ghost_tetrahedralization.hpp"

namespace leonhard::delaunay {

/// Tetrahedra into an order that depends on nothing but which vertices they join: by their vertices, the least first. The
/// vertices of each come in rising order but for the last two, which are in the order that makes it positive. Ghosts and
/// dead tetrahedra are dropped, a neighbour that was a ghost is none.
///
/// cells     its vertices are 0 to vertices - 1; dead tetrahedra have the ghost at all corners
/// threads   0: as many as there are cores; the answer does not depend on it
/// Cost O(t log t) for t tetrahedra, nearly O(t); in place but for 8 bytes a tetrahedron.
void sort_and_drop_ghosts(GhostTetrahedralization& cells, std::size_t vertices, unsigned threads);

/// The same without sorting: the last tetrahedra take the numbers of those that are dropped.
void drop_ghosts(GhostTetrahedralization& cells);

}  // namespace leonhard::delaunay
