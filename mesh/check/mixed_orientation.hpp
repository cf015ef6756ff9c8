// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "leonhard/kernel/sign.hpp"
#include "leonhard/mesh/mixed_mesh.hpp"

namespace leonhard::mesh {

/// How a cell is turned: of the plane the triangles of each corner and its two neighbours, by exact orient2d; of space the
/// tetrahedra of each corner and its three neighbours along edges, by exact orient3d (of a pyramid at the corners of its base,
/// which is where three edges meet; of a tetrahedron all four are the same one).
struct Orientation {
  Sign sign;  ///< positive or negative if all are so, else zero
  std::optional<std::size_t>
      odd{};        ///< the first corner whose sign is unlike that of most, if not all are the same
  Sign odd_sign{};  ///< and its sign
};

/// mesh  its ids in range
template <int Dim>
[[nodiscard]] Orientation orientation_of(const MixedMesh<Dim>& mesh, CellId cell);

/// What is wrong with a cell that is not positive, e.g. "prism 4 (vertices ... at ...) is turned over: its volume is
/// negative".
template <int Dim>
[[nodiscard]] std::string orientation_words(const MixedMesh<Dim>& mesh, CellId cell, const Orientation& turn);

}  // namespace leonhard::mesh
