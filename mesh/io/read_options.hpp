// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

namespace leonhard::io {

/// What a reader of meshes is asked to do with what it reads.
struct ReadOptions {
  /// Quadrilaterals become triangles along their Delaunay diagonals, and cells of space tetrahedra (mesh::split_cells).
  bool split = false;
  /// Vertices that are no farther apart than this become one; 0: those of equal coordinates. None: all stay as they are.
  std::optional<double> weld{};
  /// Which zone of a file of several (SU2), from 1. None: the only one.
  std::optional<std::size_t> zone{};
};

}  // namespace leonhard::io
