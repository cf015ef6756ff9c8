// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "leonhard/mesh/id.hpp"

/// Answers to questions about a point among vertices of the plane or of space.
namespace leonhard::delaunay {

/// Where a point of the plane lies.
enum class PointLocationKind {
  on_vertex,    ///< at vertices[0]
  on_edge,      ///< strictly between vertices[0] < vertices[1], of the triangulation or of the line
  in_triangle,  ///< strictly inside the triangle of the three vertices, counter-clockwise, the least id first
  outside,  ///< not in the convex hull of the vertices, which may be a triangle, a segment, a point or nothing
};

/// Where a point of space lies.
enum class TetLocationKind {
  on_vertex,       ///< at vertices[0]
  on_edge,         ///< strictly between vertices[0] < vertices[1]
  on_face,         ///< strictly inside the triangle of vertices[0] < vertices[1] < vertices[2]
  in_tetrahedron,  ///< strictly inside that of the four vertices, positive, the two least first, in rising order
  in_span,  ///< while all vertices are coplanar: in the plane or on the line that they span, and at none of them
  outside,  ///< not in the convex hull of the vertices; while they are coplanar, not in what they span
};

/// The word for it, e.g. "on_vertex".
[[nodiscard]] constexpr std::string_view to_string(PointLocationKind kind) {
  switch (kind) {
    case PointLocationKind::on_vertex:
      return "on_vertex";
    case PointLocationKind::on_edge:
      return "on_edge";
    case PointLocationKind::in_triangle:
      return "in_triangle";
    case PointLocationKind::outside:
      return "outside";
  }
  return "";
}
[[nodiscard]] constexpr std::string_view to_string(TetLocationKind kind) {
  switch (kind) {
    case TetLocationKind::on_vertex:
      return "on_vertex";
    case TetLocationKind::on_edge:
      return "on_edge";
    case TetLocationKind::on_face:
      return "on_face";
    case TetLocationKind::in_tetrahedron:
      return "in_tetrahedron";
    case TetLocationKind::in_span:
      return "in_span";
    case TetLocationKind::outside:
      return "outside";
  }
  return "";
}

/// Whether there is a vertex, an edge, a triangle or a tetrahedron that holds the point.
[[nodiscard]] constexpr bool is_inside(PointLocationKind kind) { return kind != PointLocationKind::outside; }
[[nodiscard]] constexpr bool is_inside(TetLocationKind kind) {
  return kind != TetLocationKind::outside && kind != TetLocationKind::in_span;
}

/// Where a point lies: a closed set of answers, each of which depends on the vertices and the point alone.
template <class KindT, std::size_t corners>
struct SimplexLocation {
  using Kind = KindT;

  Kind kind = Kind::outside;
  std::array<MaybeId<VertexId>, corners> vertices;  ///< as many as the kind says, then none

  [[nodiscard]] bool inside() const { return is_inside(kind); }
  friend bool operator==(const SimplexLocation&, const SimplexLocation&) = default;
};
using PointLocation = SimplexLocation<PointLocationKind, 3>;
using TetLocation = SimplexLocation<TetLocationKind, 4>;

/// A vertex's part in a convex combination.
struct VertexWeight {
  VertexId vertex;
  double weight;
  friend bool operator==(const VertexWeight&, const VertexWeight&) = default;
};

/// Vertices whose convex combination a point is.
template <class LocationT>
struct WeightsAt {
  typename LocationT::Kind where = LocationT::Kind::outside;
  std::vector<VertexWeight> weights;  ///< of sum 1; empty unless inside

  [[nodiscard]] bool inside() const { return is_inside(where); }
};
using NaturalNeighbours = WeightsAt<PointLocation>;
using TetNaturalNeighbours = WeightsAt<TetLocation>;

/// A value at a point.
template <class LocationT>
struct ValueAt {
  typename LocationT::Kind where = LocationT::Kind::outside;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN unless inside

  [[nodiscard]] bool inside() const { return is_inside(where); }
};
using Interpolated = ValueAt<PointLocation>;
using TetInterpolated = ValueAt<TetLocation>;

}  // namespace leonhard::delaunay
