// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "leonhard/delaunay/voronoi_corner.hpp"
#include "leonhard/kernel/point.hpp"

namespace leonhard::delaunay {

/// The normal of a triangle, counter-clockwise as seen from where it points to, of length 1; 0 where it is too thin for
/// doubles to say.
[[nodiscard]] Vec3 unit_normal(const Point3& a, const Point3& b, const Point3& c);

/// The circumcentre of a tetrahedron, positive, as near as doubles can say.
[[nodiscard]] VoronoiCorner<Point3> rounded_circumcentre(const std::array<Point3, 4>& corners);

}  // namespace leonhard::delaunay
