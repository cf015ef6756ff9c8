// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "leonhard/delaunay/extent.hpp"
#include "leonhard/delaunay/topology/tet_arena.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// Do three points of space lie on one line? Exact for all finite coordinates; true if two of them are equal.
[[nodiscard]] bool are_collinear(const Point3& a, const Point3& b, const Point3& c);

/// The first points of a set that are affinely independent: where an incremental construction starts.
struct FirstTetrahedron {
  Extent extent = Extent::nothing;
  /// Indices of 0, 1, 2, 3 or 4 points, by the extent. In space kernel::orient3d of the four is positive.
  std::array<std::size_t, 4> points{};

  /// How many of the indices count.
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(extent); }
};

/// Find four points with a tetrahedron between them, or what the points span if there are none.
///
/// points   finite, repeated points welcome
/// order    indices of points, of all or some; each point taken is the first in this order that is not in the span of
///          those before it (the first two of the four may be swapped to make the tetrahedron positive)
/// Exact. Cost O(n) at worst, O(1) if the first four points are independent.
[[nodiscard]] FirstTetrahedron first_tetrahedron(std::span<const Point3> points,
                                                 std::span<const std::uint32_t> order);
/// The same in the order of the points themselves.
[[nodiscard]] FirstTetrahedron first_tetrahedron(std::span<const Point3> points);
[[nodiscard]] FirstTetrahedron first_tetrahedron(std::span<const TetNode> nodes);

}  // namespace leonhard::delaunay
