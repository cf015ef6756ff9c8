// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::mesh {

/// A face by its vertices in ascending order, and in which direction they were given.
struct SortedFace {
  std::array<VertexId, 3> corners;  ///< ascending
  bool even;  ///< whether the order given is an even permutation of this one, as 1, 2, 0 is

  /// The order given, up to the corner to begin with: the smallest comes first.
  [[nodiscard]] std::array<VertexId, 3> directed() const {
    return even ? corners : std::array{corners[0], corners[2], corners[1]};
  }
};

/// corners  distinct
[[nodiscard]] inline SortedFace sorted_face(std::array<VertexId, 3> corners) {
  auto& [a, b, c] = corners;
  bool even = true;
  const auto in_order = [&even](VertexId& first, VertexId& second) {
    if (first < second) return;
    std::swap(first, second);
    even = !even;
  };
  in_order(a, b);
  in_order(b, c);
  in_order(a, b);
  return {corners, even};
}

/// The face opposite corners[side], counter-clockwise as seen from outside the tetrahedron.
[[nodiscard]] inline std::array<VertexId, 3> outward_face(const std::array<VertexId, 4>& corners,
                                                          std::size_t side) {
  const auto& [i, j, k] = tet_face_corners[side];
  return {corners[i], corners[j], corners[k]};
}

}  // namespace leonhard::mesh
