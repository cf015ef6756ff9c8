// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard::mesh {

/// A facet by its vertices in ascending order, and in which direction they were given.
///
/// count  of its corners: 2 for an edge of a triangle, 3 for a face of a tetrahedron
template <std::size_t count>
struct SortedFacet {
  std::array<VertexId, count> corners;  ///< ascending
  bool even;  ///< whether the order given is an even permutation of this one, as 1, 2, 0 is

  /// The order given, up to the corner of a face to begin with: the smallest comes first.
  [[nodiscard]] std::array<VertexId, count> directed() const {
    auto given = corners;
    if (!even) std::swap(given[count - 2], given[count - 1]);
    return given;
  }
  friend bool operator==(const SortedFacet&, const SortedFacet&) = default;
};

/// corners  distinct
template <std::size_t count>
[[nodiscard]] SortedFacet<count> sorted_facet(std::array<VertexId, count> corners) {
  bool even = true;
  const auto in_order = [&even](VertexId& first, VertexId& second) {
    if (first < second) return;
    std::swap(first, second);
    even = !even;
  };
  in_order(corners[0], corners[1]);
  if constexpr (count == 3) {
    in_order(corners[1], corners[2]);
    in_order(corners[0], corners[1]);
  }
  return {corners, even};
}

/// The facet opposite corners[side], directed outwards (see Simplex).
template <std::size_t cell_corners>
[[nodiscard]] std::array<VertexId, cell_corners - 1> outward_facet(
    const std::array<VertexId, cell_corners>& corners, std::size_t side) {
  const auto& numbers = Simplex<static_cast<int>(cell_corners) - 1>::facet_corners[side];
  std::array<VertexId, cell_corners - 1> facet;
  for (std::size_t i = 0; i < facet.size(); ++i) facet[i] = corners[numbers[i]];
  return facet;
}

}  // namespace leonhard::mesh
