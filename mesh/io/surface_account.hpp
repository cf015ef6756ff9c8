// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "leonhard/mesh/io/surface_contents.hpp"

namespace leonhard {

/// What a surface is like. Edges are those of its polygons, told apart by the vertices' numbers.
struct SurfaceAccount {
  std::size_t vertices{}, unused_vertices{};
  std::size_t repeated_places{};  ///< vertices at the place of one with a smaller number
  std::size_t polygons{}, triangles{}, quadrilaterals{};
  std::size_t degenerate{};  ///< polygons with a vertex twice or without area
  std::size_t edges{};
  std::size_t open_edges{};     ///< of one polygon
  std::size_t crowded_edges{};  ///< of three or more
  std::size_t unlike_edges{};   ///< of two polygons that run along them in the same direction
  std::size_t components{};     ///< joined across edges
  std::size_t contacts{};       ///< pairs of triangles that meet beyond common corners and edges
  double area{};
  double
      volume{};  ///< enclosed, negative if the polygons turn inwards; says something if is_closed() and is_oriented()

  [[nodiscard]] bool is_closed() const { return polygons > 0 && open_edges == 0; }
  [[nodiscard]] bool is_manifold() const { return crowded_edges == 0; }
  [[nodiscard]] bool is_oriented() const { return unlike_edges == 0; }
};

namespace io {

/// Counts, exact but for area and volume. Polygons of more than three corners are taken as the triangles from their first one.
/// Cost O(n log n), if few triangles are near each other.
[[nodiscard]] SurfaceAccount surface_account(const SurfaceFile& surface);

/// Vertices no farther apart than the tolerance become one (0: those of equal coordinates), and polygons that lose corners so
/// that fewer than three stay go. The warnings tell both.
/// throws  InputError if the tolerance is negative or not finite
void weld(SurfaceFile& surface, double tolerance);

}  // namespace io
}  // namespace leonhard
