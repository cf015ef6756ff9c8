// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::mesh {

/// An edge of a boundary face: its ends, ascending, the face's third corner, and the face's entry in mesh.boundary.
struct BoundarySide {
  VertexId low, high, apex;
  std::size_t face;
};

/// The three edges of every boundary face, sorted by ends, then by face.
[[nodiscard]] inline std::vector<BoundarySide> boundary_sides(const TetMesh& mesh) {
  std::vector<BoundarySide> sides;
  sides.reserve(3 * mesh.boundary.size());
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& corners = mesh.boundary[f].corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId from = corners[(i + 1) % 3], to = corners[(i + 2) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), corners[i], f});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const BoundarySide& s, const BoundarySide& t) {
    return std::tie(s.low, s.high, s.face) < std::tie(t.low, t.high, t.face);
  });
  return sides;
}

}  // namespace leonhard::mesh
