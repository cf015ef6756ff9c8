// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "leonhard/mesh/id.hpp"

namespace leonhard::mesh {

/// What of a mesh a point lies on: of the smallest dimension that holds it.
enum class Place : std::uint8_t {
  outside,
  on_vertex,
  on_edge,  ///< strictly between its ends
  on_face,  ///< strictly inside a face; of tetrahedral meshes only
  in_cell,  ///< strictly inside a triangle or a tetrahedron
};

/// The word for it, e.g. "on_vertex".
[[nodiscard]] constexpr std::string_view to_string(Place place) {
  switch (place) {
    case Place::outside:
      return "outside";
    case Place::on_vertex:
      return "on_vertex";
    case Place::on_edge:
      return "on_edge";
    case Place::on_face:
      return "on_face";
    case Place::in_cell:
      return "in_cell";
  }
  return "";
}

/// Where a point lies in a mesh.
template <class CellId, std::size_t corners>
struct MeshLocation {
  Place place = Place::outside;
  /// Of the triangles (tetrahedra) that hold the point, on their boundary too, the one of smallest id; none outside.
  MaybeId<CellId> cell;
  /// Of that cell's vertices those that span the place, in ascending order: 1 on a vertex, 2 on an edge and so on; then
  /// none.
  std::array<MaybeId<VertexId>, corners> vertices;

  [[nodiscard]] bool inside() const { return place != Place::outside; }
  friend bool operator==(const MeshLocation&, const MeshLocation&) = default;
};

/// Vertices whose convex combination a point is: barycentric coordinates.
template <std::size_t corners>
struct VertexWeights {
  std::size_t count = 0;  ///< of vertices: those that span the place
  std::array<VertexId, corners> vertices{};
  std::array<double, corners> weights{};  ///< >= 0, their sum 1 but for rounding; exactly 1 at a vertex

  /// The sum of weights times values, held to the range of those values: where all are equal, exactly that.
  ///
  /// values  indexed by vertices, such as PerId<VertexId, double>
  template <class Values>
  [[nodiscard]] double of(const Values& values) const {
    double sum = 0, least = 0, greatest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double value = values[vertices[i]];
      sum += weights[i] * value;
      least = i == 0 ? value : std::min(least, value);
      greatest = i == 0 ? value : std::max(greatest, value);
    }
    return sum < least ? least : sum > greatest ? greatest : sum;
  }
};

}  // namespace leonhard::mesh
