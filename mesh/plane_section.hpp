// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "leonhard/mesh/tet_mesh.hpp"
#include "leonhard/mesh/triangle_mesh.hpp"

namespace leonhard {

/// An axis of space.
enum class SpaceAxis : std::uint8_t { x, y, z };

/// A point of a section on an edge of what is cut: `share` of the way from low to high. On a vertex itself both are that vertex.
struct SectionPoint {
  VertexId low, high;
  double share{};

  /// A value that is linear along the edge. values: one a vertex
  [[nodiscard]] double of(std::span<const double> values) const {
    const double from = values[low.index()];
    return low == high ? from : from + share * (values[high.index()] - from);
  }
  friend bool operator==(const SectionPoint&, const SectionPoint&) = default;
};

/// Where a plane cuts a tetrahedral mesh.
struct PlaneSection {
  TriangleMesh mesh;                       ///< coordinates are the other two axes, in their order
  PerId<VertexId, SectionPoint> vertices;  ///< of `mesh`, as they lie in what was cut
};

/// Where a plane cuts a triangle of a surface.
using SectionSegment = std::array<SectionPoint, 2>;

namespace mesh {

/// The section of a mesh by the plane on which a coordinate has a value. Which side a vertex is on is decided by comparing its
/// coordinate, exactly; vertices in the plane stay vertices, and what touches the plane alone is left out, so that each part of
/// the plane is covered once. Triangles are turned as their tetrahedra tell, counter-clockwise; those that rounding makes
/// flat stay. The boundary has the marker 1.
///
/// returns  no triangles where the plane passes by
/// throws   InputError on an id out of range
/// mesh     its tetrahedra positive; neighbours are not read
/// Cost O(tetrahedra + section log section).
[[nodiscard]] PlaneSection plane_section(const TetMesh& mesh, SpaceAxis axis, double position);

/// The same of triangles in space, as segments in no order.
/// throws  InputError on an id out of range
[[nodiscard]] std::vector<SectionSegment> plane_section(const PerId<VertexId, Point3>& points,
                                                        std::span<const std::array<VertexId, 3>> triangles, SpaceAxis axis,
                                                        double position);

}  // namespace mesh
}  // namespace leonhard
