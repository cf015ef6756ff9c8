// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// A side of a triangle or a tetrahedron: that opposite corners[cell][side].
template <class CellId>
struct CellSide {
  CellId cell;
  unsigned side;
  friend auto operator<=>(const CellSide&, const CellSide&) = default;
};

/// To each entry of mesh.boundary the side that it is.
///
/// throws  InputError if mesh.boundary has not each side without neighbour once, or neighbours are not as many as cells
/// Cost O(cells + boundary log boundary).
[[nodiscard]] std::vector<CellSide<TriangleId>> boundary_cells(const TriangleMesh& mesh);
[[nodiscard]] std::vector<CellSide<TetId>> boundary_cells(const TetMesh& mesh);

}  // namespace leonhard::mesh
