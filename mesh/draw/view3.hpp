// SPDX-License-Identifier: MIT
#pragma once

#include "leonhard/kernel/point.hpp"
#include "leonhard/mesh/tet_mesh.hpp"

namespace leonhard::draw {

/// Where a picture of space is seen from; z is up. The default looks from the front, a little from the right and above:
/// x runs to the right, y away from the viewer.
struct View3 {
  double azimuth_deg = -60;      ///< of the direction to the viewer, in the x-y plane from x towards y
  double elevation_deg = 25;     ///< of the direction to the viewer above the x-y plane, -90 to 90
  double field_of_view_deg = 0;  ///< 0: parallel projection; up to 60: perspective, 20 being mild
};

/// The box of a mesh's vertices.
struct Box3 {
  Point3 low{}, high{};
  friend bool operator==(const Box3&, const Box3&) = default;
};

/// A plane that cuts a mesh open: what lies on the side to which the normal points is removed. The normal need not have
/// length 1.
struct CutPlane {
  Point3 point{};
  Vec3 normal{};
  friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

/// How the plane takes tetrahedra away.
enum class CutStyle {
  none,      ///< nothing is removed
  crinkled,  ///< tetrahedra whose centre lies beyond the plane are removed whole
  planar,    ///< all beyond the plane is removed, what it cuts shows as polygons
};

/// A point in the axes of a parallel view: x to the right, y up, z towards the viewer, lengths kept. The field of view
/// plays no part.
[[nodiscard]] Point3 seen_from(const View3& view, const Point3& p);

enum class Axis3 { x, y, z };

/// The box of the vertices that tetrahedra use. throws InputError if there is no tetrahedron
[[nodiscard]] Box3 box_of(const TetMesh& mesh);

/// The plane where a coordinate has a value; the side towards the viewer is removed.
[[nodiscard]] CutPlane cut_across(Axis3 axis, double position, const View3& view);

/// The plane through the middle of the box, across the axis that points most towards the viewer.
[[nodiscard]] CutPlane cut_through_middle(const Box3& box, const View3& view);

}  // namespace leonhard::draw
